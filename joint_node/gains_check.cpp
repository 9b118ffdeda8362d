#include "joint_node/gains_check.hpp"

#include <cmath>

#include "control/model/model_rows.hpp"
#include "plant/joint_physics.hpp"
#include "signals/fields.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::joint_node {
namespace {

struct FiniteCheck {
  const char* first_bad = nullptr;

  template <class Field>
  void operator()(const char* name, const Field& field) {
    if constexpr (std::is_same_v<Field, double>) {
      if (!std::isfinite(field) && first_bad == nullptr) {
        first_bad = name;
      }
    } else if constexpr (requires { field.size(); }) {
      for (const auto& element : field) {
        (*this)(name, element);
      }
    }
  }
};

Result<Done> check_physics(const signals::JointControllerGains& signal) {
  if (signal.has_physics == 0) {
    return Error{"no physics, which a controller that inverts the flow law needs: give has_physics and physics"};
  }
  if (const char* bad = plant::first_unphysical(plant::physics_of(signal.physics))) {
    return Error{std::string("physics: ") + bad + " is not finite or out of its range"};
  }
  return Done{};
}

}  // namespace

Result<Done> check_gains(const signals::JointControllerGains& signal, control::Kind kind) {
  FiniteCheck check;
  signals::visit_fields(signal, check);
  if (check.first_bad != nullptr) {
    return Error{std::string(check.first_bad) + " is not finite"};
  }
  if (signal.delay_ticks > signal.k_delay.size()) {
    return Error{"delay_ticks is " + std::to_string(signal.delay_ticks) + ": give 0 to 2"};
  }
  if (!known(signal.phase)) {
    return Error{"phase is " + std::to_string(static_cast<int>(signal.phase)) + ": give 0 (swing) or 1 (stance)"};
  }
  if (control::takes_physics(kind)) {
    return check_physics(signal);
  }
  const control::Gains gains = wire_gains::unpack_gains(signal);
  const control::Normalisation& n = gains.normalisation;
  if (!(n.position > 0 && n.velocity > 0 && n.force > 0 && n.current_A > 0)) {
    return Error{"a scale is not positive"};
  }
  if (!(gains.integral * gains.integral_factor > 0)) {
    return Error{"no integral action"};
  }
  // The compliant loop is judged without the position state, so nothing may lean on it.
  if (gains.form == control::Form::kCompliant && gains.position != 0.0) {
    return Error{"compliant gains with a position gain of " + std::to_string(gains.position)};
  }
  const double radius = control::closed_loop_spectral_radius(gains.model, gains, gains.delay_ticks);
  if (!(radius < 1.0)) {
    return Error{"closed loop unstable for the model they came with: spectral radius " + std::to_string(radius)};
  }
  return Done{};
}

}  // namespace farrier::joint_node
