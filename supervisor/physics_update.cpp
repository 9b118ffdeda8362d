#include "supervisor/physics_update.hpp"

#include <algorithm>
#include <cmath>

#include "control/model/model_rows.hpp"
#include "estimation/estimator.hpp"
#include "robot/joint_model.hpp"

namespace farrier::supervisor {
namespace {

using signals::UpdateVerdict;

constexpr std::size_t kLoadCount = plant::kBiasForce + 1;  // of JointPhysics, the load before valve and oil

constexpr double kOverlapScale = 0.05;  // of full current
constexpr double kLeakageScale = 0.05;  // of the open valve's flow at supply pressure

/// Reference sizes for relative changes of quantities that may be zero.
std::array<double, plant::kPhysicsCount> least_scales(const robot::Joint& joint) noexcept {
  const control::Normalisation& n = joint.normalisation;
  const plant::ActuatorParams& a = joint.actuator;
  return plant::values_of(
      {.load_mass = 0.0,
       .damping = 0.0,
       .coulomb = n.force,
       .stiffness = n.force / n.position,
       .bias_force = n.force,
       .valve_gain = 0.0,
       .bulk_modulus = 0.0,
       .leakage = kLeakageScale * a.valve_gain * a.valve_current_max_A / std::sqrt(a.supply_pressure_Pa),
       .overlap_A = kOverlapScale * a.valve_current_max_A});
}

}  // namespace

PhysicsUpdate::PhysicsUpdate(const robot::Joint& joint, const robot::UpdateLogicParams& logic, double period_s,
                             int estimate_period_ticks, int loop_delay_ticks, const plant::JointPhysics& first,
                             const std::vector<plant::LoadParams>& loads_to_hold, bool keeps_load)
    : logic_(logic),
      keeps_load_(keeps_load),
      law_(joint, period_s, loop_delay_ticks),
      least_scale_(least_scales(joint)),
      estimate_period_s_(estimate_period_ticks * period_s),
      physics_(first) {
  for (const plant::LoadParams& load : loads_to_hold) {
    physics_to_hold_.push_back(robot::nominal_physics(joint, load));
  }
}

void PhysicsUpdate::adopt(const plant::JointPhysics& physics, const control::DiscreteModel& model) noexcept {
  physics_ = physics;
  model_ = model;
  doubted_ = false;
  contradicted_s_ = 0.0;
}

signals::JointUpdateDecision PhysicsUpdate::look(const signals::JointModelEstimate& estimate, Tick tick) noexcept {
  signals::JointUpdateDecision decision = record_of(estimate, tick);
  signals::JointModelEstimate taken = estimate;
  if (keeps_load_) {
    const std::array<double, plant::kPhysicsCount> stored = plant::values_of(physics_);
    std::copy_n(stored.begin(), kLoadCount, taken.physics.begin());
    std::fill_n(taken.physics_error.begin(), kLoadCount, 0.0);
  }
  const UpdateVerdict verdict = judge(taken);
  decision.verdict = verdict;
  news_.take(verdict);
  return decision;
}

UpdateVerdict PhysicsUpdate::judge(const signals::JointModelEstimate& estimate) noexcept {
  const plant::JointPhysics estimated = plant::physics_of(estimate.physics);
  const control::DiscreteModel model = control::model_of_rows(estimate.a, estimate.b);
  if ((estimate.flags & estimation::bit(estimation::EstimateFlag::kCountsAsStronger)) != 0) {
    return calm(estimated.valve_gain, model);
  }
  if (!(estimate.validity > 0.0) || estimate.validity < logic_.validity_min || estimate.has_physics == 0 ||
      plant::first_unphysical(estimated) != nullptr || !model.a.allFinite() || !model.b.allFinite()) {
    return UpdateVerdict::kNotValid;
  }
  if (!doubted_ && !differs(estimate)) {
    contradicted_s_ = 0.0;
    return UpdateVerdict::kNotDifferentEnough;
  }
  if (!law_.settles(estimated, estimated)) {
    return UpdateVerdict::kUnstableOnEstimate;
  }
  if (!law_.settles(estimated, stored_towards(estimated)) ||
      !std::ranges::all_of(physics_to_hold_, [&](const auto& known) { return law_.settles(estimated, known); })) {
    contradicted_s_ += estimate_period_s_;
    return UpdateVerdict::kUnstableOnStoredModel;
  }
  adopt(estimated, model);
  return UpdateVerdict::kAccepted;
}

// The law for a stronger valve is slower, which no check needs to allow.
UpdateVerdict PhysicsUpdate::calm(double valve_gain, const control::DiscreteModel& model) noexcept {
  if (!(valve_gain > physics_.valve_gain) || !std::isfinite(valve_gain) || !model.a.allFinite() ||
      !model.b.allFinite()) {
    return UpdateVerdict::kNotValid;
  }
  plant::JointPhysics calmer = physics_;
  calmer.valve_gain = valve_gain;
  adopt(calmer, model);
  return UpdateVerdict::kAccepted;
}

double PhysicsUpdate::scale(std::size_t i) const noexcept {
  return std::max(std::abs(plant::values_of(physics_)[i]), least_scale_[i]);
}

bool PhysicsUpdate::differs(const signals::JointModelEstimate& estimate) const noexcept {
  const std::array<double, plant::kPhysicsCount> stored = plant::values_of(physics_);
  for (std::size_t i = 0; i < stored.size(); ++i) {
    const double change = std::abs(estimate.physics[i] - stored[i]);
    if (change > logic_.physics_change_min * scale(i) && change > estimate.physics_error[i]) {
      return true;
    }
  }
  return false;
}

// The stored physics, every value moved towards the estimate by at most its uncertainty.
plant::JointPhysics PhysicsUpdate::stored_towards(const plant::JointPhysics& estimated) const noexcept {
  const double uncertainty = logic_.model_uncertainty + logic_.uncertainty_growth_1_s * contradicted_s_;
  std::array<double, plant::kPhysicsCount> moved = plant::values_of(physics_);
  const std::array<double, plant::kPhysicsCount> wanted = plant::values_of(estimated);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const double reach = uncertainty * scale(i);
    moved[i] += std::clamp(wanted[i] - moved[i], -reach, reach);
  }
  return plant::physics_of(moved);
}

}  // namespace farrier::supervisor
