// Estimator and supervisor behind samples of any content.

#include <cmath>

#include "control/model/model_rows.hpp"
#include "estimator_service/estimator_service.hpp"
#include "joint_node/gains_check.hpp"
#include "participant/sequence.hpp"
#include "robot/joint_model.hpp"
#include "supervisor/supervisor.hpp"
#include "tests/fuzz/input.hpp"
#include "tests/fuzz/robots.hpp"

namespace farrier::fuzz {
namespace {

constexpr std::uint64_t kSession = 77;
constexpr int kDelayTicks = 1;
constexpr std::uint16_t kJoint = 2;  // lf_kfe

template <class Signal>
bool finite(const Signal& signal) {
  bool all = true;
  const auto check = [&](const char*, const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if constexpr (std::is_same_v<Field, double>) {
      all = all && std::isfinite(field);
    } else if constexpr (requires { requires std::is_same_v<typename Field::value_type, double>; }) {
      all = all && std::ranges::all_of(field, [](double value) { return std::isfinite(value); });
    }
  };
  signals::visit_fields(signal, check);
  return all;
}

using Service = farrier::estimator_service::EstimatorService;
using Supervisor = farrier::supervisor::Supervisor;

const Service& fresh_service(std::size_t which) {
  static const auto made = [] {
    std::vector<Service> services;
    for (const char* section : {"rls", "greybox"}) {
      auto service = Service::create(load_hyq(section), kDelayTicks);
      require(service.ok(), "a shipped robot has estimators");
      services.push_back(std::move(service).value());
    }
    return services;
  }();
  return made[which];
}

const Supervisor& fresh_supervisor(std::size_t which) {
  static const auto made = [] {
    std::vector<Supervisor> supervisors;
    for (const control::Kind kind : {control::Kind::kLqr, control::Kind::kFlowInversion}) {
      auto supervisor =
          Supervisor::create(load_hyq({}, kind), farrier::supervisor::Design::kAdaptive, kDelayTicks, kSession);
      require(supervisor.ok(), "a shipped robot has gains");
      supervisors.push_back(std::move(supervisor).value());
    }
    return supervisors;
  }();
  return made[which];
}

void require_estimate(const signals::JointModelEstimate& estimate) {
  require(finite(estimate), "an estimate is finite");
  require(estimate.validity >= 0.0 && estimate.validity <= 1.0, "validity is 0 to 1");
  require(known(estimate.phase), "an estimate is of a phase there is");
}

}  // namespace

void estimator_service(Bytes bytes) {
  Input input(bytes);
  Service service = fresh_service(input.below(2));
  const robot::Joint& joint = hyq().joints[kJoint];
  const double home = joint.linkage.position(joint.home_angle_rad);
  signals::JointMeasurement measurement;
  for (int i = 0; !input.empty(); ++i) {
    measurement.joint = input.byte() == 0 ? input.raw<std::uint16_t>() : kJoint;
    measurement.tick = input.tick(measurement.tick);
    const std::size_t odd = input.below(12);
    measurement.position_m_or_rad = odd == 0 ? input.number(0.1) : home + 1e-4 * input.byte();
    measurement.velocity_m_s_or_rad_s = odd == 1 ? input.number(5) : 1e-3 * input.byte();
    measurement.force_N_or_Nm = odd == 2 ? input.number(1e4) : 10.0 * input.byte();
    measurement.valve_current_A = odd == 3 ? input.number(0.02) : 1e-5 * input.byte();
    measurement.phase = odd == 4 ? static_cast<signals::Phase>(input.byte()) : measurement.phase;
    service.take(measurement);
    if (i % 10 == 9 || input.empty()) {
      require_estimate(service.estimate(measurement.joint, measurement.tick));
    }
  }
}

void supervisor(Bytes bytes) {
  Input input(bytes);
  const std::size_t which = input.below(2);
  const control::Kind kind = which == 0 ? control::Kind::kLqr : control::Kind::kFlowInversion;
  Supervisor supervisor = fresh_supervisor(which);
  const robot::Joint& joint = hyq().joints[kJoint];
  const control::DiscreteModel model = robot::model_of(joint, joint.stance_load, hyq().period_s);
  // Ticks as its process lets them through.
  participant::Sequence ticks;
  SteadyTime now{std::chrono::seconds(1)};
  Tick tick = 0;
  ticks.take(tick, now);
  supervisor.step(tick);
  while (!input.empty()) {
    auto estimate = input.byte() % 2 == 0 ? input.signal<signals::JointModelEstimate>() : signals::JointModelEstimate{};
    estimate.joint = input.byte() == 0 ? estimate.joint : kJoint;
    estimate.phase = static_cast<signals::Phase>(input.below(3));
    if (estimate.validity == 0.0) {  // a sure estimate of a joint that is near the nominal one
      estimate.a = control::rows_of(model.a);
      estimate.b = control::entries_of(model.b);
      estimate.a[input.below(9)] *= 1.0 + input.number(1.0);
      estimate.b[2] *= 1.0 + input.number(1.0);
      estimate.b_error[2] = input.number(1.0);
      estimate.validity = 1.0;
      estimate.samples = 500;
      estimate.has_physics = 1;
      estimate.physics = plant::values_of(plant::nominal_physics(joint.actuator, joint.stance_load));
      estimate.physics[input.below(8)] *= 1.0 + input.number(1.0);
    }
    // The same estimate often enough to be believed.
    for (std::size_t look = 0; look <= input.below(32); ++look) {
      now += std::chrono::milliseconds(input.byte());
      const Tick next = input.tick(tick);
      tick = ticks.take(next, now) ? next : tick;
      supervisor.take(estimate, tick);
      if (input.byte() == 0) {
        supervisor.take(input.signal<signals::SystemRequest>());
      }
      for (const auto& gains : supervisor.step(tick).gains) {
        const auto checked = farrier::joint_node::check_gains(gains, kind);
        require(checked.ok(), "issued gains pass the joint's check: " + (checked ? "" : checked.error().message));
      }
    }
  }
}

}  // namespace farrier::fuzz
