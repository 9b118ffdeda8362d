#include "trials/armed_joint.hpp"

#include "robot/joint_model.hpp"
#include "supervisor/joint_design.hpp"

namespace farrier::trials {

Result<joint_node::JointNode> armed_joint(const robot::Joint& own, const robot::Joint& known, double period_s,
                                          int delay_ticks) {
  constexpr std::uint32_t kFirst = 1;
  joint_node::JointNode node(own, {}, period_s, delay_ticks, 0);
  node.set_mode({.robot = 0, .epoch = kFirst, .session = 0, .effective_tick = 0, .mode = signals::Mode::kArmed});
  const auto gains = FARRIER_TRY(supervisor::design_joint(known, known.swing_load, period_s, delay_ticks));
  signals::JointControllerGains signal;
  signal.joint = own.number;
  signal.phase = signals::Phase::kStance;  // the phase a node begins in
  signal.authority = kFirst;
  signal.generation = kFirst;
  signal.effective_tick = 0;
  signal.has_physics = 1;
  signal.physics = plant::values_of(robot::nominal_physics(known, known.swing_load));
  node.store_gains(signal, gains);
  return node;
}

}  // namespace farrier::trials
