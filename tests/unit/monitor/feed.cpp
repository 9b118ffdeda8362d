#include "feed.hpp"

#include "control/model/discretise.hpp"
#include "control/model/model_rows.hpp"

namespace farrier::monitor::testing {

signals::JointModelEstimateCopy estimate(std::uint16_t joint, Tick tick, double mass) {
  // (3.47) and a line of oil between the piston's velocity and the load cell's force.
  constexpr double kStiffness = 5e6, kDamping = 20.0, kLeak = 50.0, kGain = 2e7;
  Eigen::Matrix3d a;
  a << 0.0, 1.0, 0.0,                     //
      0.0, -kDamping / mass, 1.0 / mass,  //
      0.0, -kStiffness, -kLeak;
  const control::DiscreteModel model = control::discretise(a, {0.0, 0.0, kGain}, hyq().period_s);
  signals::JointModelEstimateCopy e;
  e.joint = joint;
  e.tick = tick;
  e.a = control::rows_of(model.a);
  e.b = control::entries_of(model.b);
  e.validity = 0.9;
  return e;
}

void walk_for_a_second(Feed& feed) {
  std::uint16_t number = 0;
  for (const char* name : {"sim_bridge", "supervisor", "joint_node_lf"}) {
    feed.take(hello(number, name));
    signals::SystemHealth health;
    health.participant = number;
    health.tick = 500;
    health.periods = 499;
    health.missed_periods = 1;
    health.sent[0] = 6000;
    health.lost[0] = number;
    if (number == 0) {
      health.latency_s = {450e-6, 900e-6, 1e-3, 2e-3};
      health.wake_up_s = {50e-6, 90e-6, 1e-4, 2e-4};
    }
    feed.take(health);
    ++number;
  }
  signals::SystemMode mode;
  mode.epoch = 1;
  mode.session = kSession;
  mode.effective_tick = 0;
  mode.mode = signals::Mode::kArmed;
  feed.take(mode);
  for (const robot::Joint& joint : hyq().joints) {
    feed.take(estimate(joint.number, 400, 5.0 + joint.number));
  }
  for (const std::uint16_t joint : {signals::kNoJoint, std::uint16_t{2}}) {
    signals::SystemEvent event;
    event.participant = 1;
    event.count = joint == 2 ? 2 : 1;
    event.tick = 450;
    event.severity = joint == 2 ? signals::Severity::kError : signals::Severity::kInfo;
    event.joint = joint;
    signals::assign(event.text, joint == 2 ? "design refused" : "armed");
    feed.take(event);
  }
  feed.walk(0, 51);
}

}  // namespace farrier::monitor::testing
