#pragma once

// One joint of HyQ on a bench: armed and supplied with gains on request, stepped tick by tick.

#include <gtest/gtest.h>

#include "joint_node/gains_check.hpp"
#include "joint_node/joint_node.hpp"
#include "supervisor/joint_design.hpp"
#include "supervisor/supervisor.hpp"
#include "tests/unit/robot/test_files.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::joint_node::testing {

inline constexpr std::uint64_t kSession = 77;
inline constexpr int kNoDelay = 0;

/// HyQ without the dither and the stance lead of its file: a test that is about them sets its own.
inline const robot::Robot& hyq() {
  static const robot::Robot robot = [] {
    robot::Robot shipped = robot::load_shipped("hyq", {.without_effects = true});
    for (robot::Joint& joint : shipped.joints) {
      joint.dither_percent = 0.0;
    }
    shipped.safety.stance_lead_s = 0.0;
    shipped.safety.frozen_samples = 0;  // sensors of a bench do not move
    return shipped;
  }();
  return robot;
}

inline const robot::Joint& joint_named(const std::string& name) { return *hyq().find(name); }

inline control::Gains design(const robot::Joint& joint, const plant::LoadParams& load, int delay_ticks = kNoDelay) {
  return supervisor::design_joint(joint, load, hyq().period_s, delay_ticks).value();
}

/// The stance design of a joint as it travels.
inline signals::JointControllerGains gains_of(const robot::Joint& joint, signals::Phase phase, std::uint32_t generation,
                                              Tick effective_tick = 0) {
  auto signal = wire_gains::pack_gains(joint.number, phase, 1, generation, design(joint, joint.stance_load));
  signal.effective_tick = effective_tick;
  return signal;
}

inline signals::SystemMode mode_of(signals::Mode mode, std::uint32_t epoch, Tick effective_tick = 0,
                                   std::uint64_t session = kSession) {
  return {.robot = 0, .epoch = epoch, .session = session, .effective_tick = effective_tick, .mode = mode};
}

class Bench {
 public:
  explicit Bench(const std::string& name = "lf_kfe") : Bench(joint_named(name)) {}

  /// `of` must live as long as the bench.
  explicit Bench(const robot::Joint& of, const robot::Safety& safety = hyq().safety)
      : joint(of), node(joint, safety, hyq().period_s, kNoDelay, kSession) {
    inputs.sensors.joint = inputs.command.joint = joint.number;
    inputs.sensors.position_m_or_rad = joint.linkage.position(joint.home_angle_rad);
    inputs.command.position_rad = joint.home_angle_rad;
    inputs.command.stiffness_Nm_rad = joint.stiffness_Nm_rad;
    inputs.command.damping_Nms_rad = joint.damping_Nms_rad;
  }

  /// Armed, with stance and swing gains of generations 1 and 2, acting from tick 0.
  static Bench tracking(const std::string& name = "lf_kfe") { return tracking(joint_named(name)); }
  static Bench tracking(const robot::Joint& of, const robot::Safety& safety = hyq().safety) {
    Bench bench(of, safety);
    bench.node.set_mode(mode_of(signals::Mode::kArmed, 1));
    bench.offer(gains_of(bench.joint, signals::Phase::kSwing, 1));
    bench.offer(gains_of(bench.joint, signals::Phase::kStance, 2));
    return bench;
  }

  /// Takes gains as a joint_node process does.
  void offer(const signals::JointControllerGains& signal) {
    if (check_gains(signal, joint.kind)) {
      node.store_gains(signal, wire_gains::unpack_gains(signal));
    } else {
      node.refuse_gains(signal);
    }
  }

  void announce(signals::Phase phase, std::uint32_t count, Tick switch_tick) {
    node.announce_phase({.leg = static_cast<std::uint16_t>(joint.leg),
                         .count = count,
                         .announced_tick = 0,
                         .switch_tick = switch_tick,
                         .phase = phase});
  }

  /// One period with fresh sensors.
  JointNode::Outputs step() {
    inputs.tick = inputs.sensors.tick = next_tick;
    inputs.command.tick = next_tick;
    ++next_tick;
    return node.step(inputs);
  }
  JointNode::Outputs step_to(Tick tick) {
    while (next_tick < tick) {
      step();
    }
    return step();
  }
  signals::JointState state() { return static_cast<signals::JointState>(step().valve.state); }

  double angle() const { return joint.linkage.angle(inputs.sensors.position_m_or_rad); }

  const robot::Joint& joint;
  JointNode node;
  JointNode::Inputs inputs;
  Tick next_tick = 0;
};

inline bool has(const JointNode::Outputs& outputs, Fault fault) { return FaultSet(outputs.valve.faults).has(fault); }

/// The valve does nothing, and says why.
inline void expect_null(const JointNode::Outputs& outputs, Fault cause) {
  EXPECT_EQ(outputs.valve.state, signals::JointState::kNull);
  EXPECT_EQ(outputs.valve.valve_current_A, 0.0);
  EXPECT_EQ(outputs.valve.force_reference_N_or_Nm, 0.0);
  EXPECT_EQ(outputs.valve.generation, 0u);
  EXPECT_TRUE(has(outputs, cause)) << "faults: " << to_string(FaultSet(outputs.valve.faults));
}

}  // namespace farrier::joint_node::testing

namespace farrier::signals {
inline void PrintTo(JointState state, std::ostream* out) { *out << to_string(state); }
}  // namespace farrier::signals
