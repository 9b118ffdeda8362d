#include "supervisor/supervisor.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "joint_node/gains_check.hpp"
#include "supervisor/joint_design.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/unit/robot/test_files.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::supervisor {
namespace supervisor_test {

using signals::JointControllerGains;
using signals::Phase;

constexpr std::uint64_t kSession = 31;

const robot::Robot& shipped(const std::string& name) {
  static const std::map<std::string, robot::Robot> robots{{"hyq", robot::load_shipped("hyq")},
                                                          {"fc1d", robot::load_shipped("fc1d")}};
  return robots.at(name);
}

Supervisor supervisor_of(const robot::Robot& robot, Design design, int delay_ticks = 0) {
  return Supervisor::create(robot, design, delay_ticks, kSession).value();
}

TEST(Supervisor, IssuesGainsForEveryJointAndBothPhasesOnce) {
  for (const char* name : {"hyq", "fc1d"}) {
    Supervisor supervisor = supervisor_of(shipped(name), Design::kStance);
    std::multiset<std::pair<int, signals::Phase>> issued;
    for (Tick tick = 0; tick < 100; ++tick) {
      for (const JointControllerGains& gains : supervisor.step(tick).gains) {
        issued.insert({gains.joint, gains.phase});
      }
    }
    EXPECT_EQ(issued.size(), 2 * shipped(name).joints.size());
    for (const robot::Joint& joint : shipped(name).joints) {
      for (const Phase phase : {Phase::kSwing, Phase::kStance}) {
        EXPECT_EQ(issued.count({joint.number, phase}), 1u) << joint.name;
      }
    }
  }
}

TEST(Supervisor, NumbersTheGainsOfAJointFromOneUpwards) {
  Supervisor supervisor = supervisor_of(shipped("hyq"), Design::kStance);
  std::map<int, std::uint32_t> newest;
  for (const JointControllerGains& gains : supervisor.step(0).gains) {
    EXPECT_EQ(gains.generation, ++newest[gains.joint]);
  }
}

TEST(Supervisor, ArmsTheRobotForItsSessionOnce) {
  Supervisor supervisor = supervisor_of(shipped("hyq"), Design::kStance);
  const auto modes = supervisor.step(0).modes;
  ASSERT_EQ(modes.size(), 1u);
  EXPECT_EQ(modes[0].mode, signals::Mode::kArmed);
  EXPECT_EQ(modes[0].session, kSession);
  EXPECT_EQ(modes[0].epoch, 1u) << "0 is never issued";
  EXPECT_TRUE(supervisor.step(1).modes.empty());
}

TEST(Supervisor, ArmsAndStopsAsAnOperatorOfItsSessionAsks) {
  Supervisor supervisor = supervisor_of(shipped("hyq"), Design::kStance);
  supervisor.step(0);
  const auto asked = [&](signals::Request request, std::uint64_t session) {
    supervisor.take(signals::SystemRequest{.session = session, .request = request});
    return supervisor.step(1).modes;
  };
  EXPECT_TRUE(asked(signals::Request::kStop, kSession + 1).empty());
  const auto stopped = asked(signals::Request::kStop, kSession);
  ASSERT_EQ(stopped.size(), 1u);
  EXPECT_EQ(stopped[0].mode, signals::Mode::kStopped);
  EXPECT_EQ(stopped[0].epoch, 2u);
  EXPECT_EQ(stopped[0].session, kSession);
  EXPECT_EQ(stopped[0].effective_tick, 1 + shipped("hyq").update_logic.gain_lead_ticks);
  EXPECT_TRUE(supervisor.step(2).modes.empty());
  const auto armed = asked(signals::Request::kArm, kSession);
  ASSERT_EQ(armed.size(), 1u);
  EXPECT_EQ(armed[0].mode, signals::Mode::kArmed);
  EXPECT_EQ(armed[0].epoch, 3u);
}

TEST(Supervisor, LeavesTimeForWhatItIssuesToArrive) {
  Supervisor supervisor = supervisor_of(shipped("hyq"), Design::kStance);
  const auto& outputs = supervisor.step(1000);
  const int lead_ticks = shipped("hyq").update_logic.gain_lead_ticks;
  for (const JointControllerGains& gains : outputs.gains) {
    EXPECT_EQ(gains.effective_tick, 1000 + lead_ticks);
  }
  EXPECT_EQ(outputs.modes.at(0).effective_tick, 1000 + lead_ticks);
}

TEST(Supervisor, IssuesOnlyGainsThatAJointAccepts) {
  for (const char* name : {"hyq", "fc1d"}) {
    for (const Design design : {Design::kStance, Design::kSwing}) {
      for (const int delay_ticks : {0, 1, 2}) {
        Supervisor supervisor = supervisor_of(shipped(name), design, delay_ticks);
        for (const JointControllerGains& gains : supervisor.step(0).gains) {
          const auto checked = joint_node::check_gains(gains, control::Kind::kLqr);
          EXPECT_TRUE(checked) << name << " joint " << gains.joint << ": " << checked.error().message;
          EXPECT_EQ(gains.delay_ticks, delay_ticks);
        }
      }
    }
  }
}

bool load_changes(const robot::Joint& joint) { return joint.stance_load.mass != joint.swing_load.mass; }

TEST(Supervisor, DesignsForTheLoadItIsTold) {
  const auto stance = supervisor_of(shipped("hyq"), Design::kStance).step(0).gains;
  const auto swing = supervisor_of(shipped("hyq"), Design::kSwing).step(0).gains;
  ASSERT_EQ(stance.size(), swing.size());
  int changed = 0;
  for (std::size_t i = 0; i < stance.size(); ++i) {
    const robot::Joint& joint = shipped("hyq").joints[stance[i].joint];
    EXPECT_EQ(stance[i].k_force != swing[i].k_force, load_changes(joint)) << joint.name;
    EXPECT_EQ(stance[i].model_a != swing[i].model_a, load_changes(joint)) << joint.name;
    changed += load_changes(joint) ? 1 : 0;
  }
  EXPECT_EQ(changed, 2 * 8) << "hips and knees flex under the robot; the HAA motors see their leg in either phase";
}

TEST(Supervisor, GivesBothSlotsTheSameDesignUnlessToldOtherwise) {
  const auto same = supervisor_of(shipped("hyq"), Design::kStance).step(0).gains;
  const auto own = supervisor_of(shipped("hyq"), Design::kPhases).step(0).gains;
  for (std::size_t i = 0; i + 1 < same.size(); i += 2) {
    ASSERT_EQ(same[i].joint, same[i + 1].joint);
    EXPECT_EQ(same[i].k_force, same[i + 1].k_force);
    EXPECT_EQ(own[i].k_force != own[i + 1].k_force, load_changes(shipped("hyq").joints[own[i].joint]));
  }
}

TEST(Supervisor, RefusesAFullStateDesignWithoutASpringNamingTheJoint) {
  robot::Robot robot = shipped("hyq");
  robot.joints[4].form = control::Form::kFullState;
  ASSERT_EQ(robot.joints[4].stance_load.stiffness, 0.0);
  const auto refused = Supervisor::create(robot, Design::kStance, 0, kSession);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message.find(robot.joints[4].name + ": no controller"), 0u) << refused.error().message;
  EXPECT_NE(refused.error().message.find("set form: compliant"), std::string::npos) << refused.error().message;
}

TEST(Supervisor, StepDoesNotAllocate) {
  Supervisor supervisor = supervisor_of(shipped("hyq"), Design::kStance);
  const test::AllocationGuard guard;
  for (Tick tick = 0; tick < 10; ++tick) {
    supervisor.step(tick);
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST(DesignJoint, IsStableWithTheDelayItIsFor) {
  for (const char* name : {"hyq", "fc1d"}) {
    const robot::Robot& robot = shipped(name);
    for (const robot::Joint& joint : robot.joints) {
      for (const plant::LoadParams& load : {joint.swing_load, joint.stance_load}) {
        for (const int delay_ticks : {0, 1, 2}) {
          const auto gains = design_joint(joint, load, robot.period_s, delay_ticks);
          ASSERT_TRUE(gains) << gains.error().message;
          const control::Gains& g = gains.value();
          EXPECT_LT(g.spectral_radius, 1.0) << joint.name << " with " << delay_ticks;
          EXPECT_EQ(g.spectral_radius, control::closed_loop_spectral_radius(g.model, g, delay_ticks));
        }
      }
    }
  }
}

TEST(PackGains, LosesNothingOnTheWire) {
  for (const char* name : {"hyq", "fc1d"}) {
    for (const robot::Joint& joint : shipped(name).joints) {
      const control::Gains sent = design_joint(joint, joint.stance_load, 0.001, 2).value();
      const JointControllerGains signal = wire_gains::pack_gains(joint.number, Phase::kSwing, 3, 4, sent);
      EXPECT_EQ(signal.joint, joint.number);
      EXPECT_EQ(signal.phase, Phase::kSwing);
      EXPECT_EQ(signal.authority, 3u);
      EXPECT_EQ(signal.generation, 4u);
      const control::Gains got = wire_gains::unpack_gains(signal);
      EXPECT_EQ(got.position, sent.position);
      EXPECT_EQ(got.velocity, sent.velocity);
      EXPECT_EQ(got.force, sent.force);
      EXPECT_EQ(got.integral, sent.integral);
      EXPECT_EQ(got.feed_forward, sent.feed_forward);
      EXPECT_EQ(got.delay, sent.delay);
      EXPECT_EQ(got.delay_ticks, sent.delay_ticks);
      EXPECT_EQ(got.form, sent.form);
      EXPECT_EQ(got.integral_factor, sent.integral_factor);
      EXPECT_EQ(got.normalisation.position, sent.normalisation.position);
      EXPECT_EQ(got.normalisation.velocity, sent.normalisation.velocity);
      EXPECT_EQ(got.normalisation.force, sent.normalisation.force);
      EXPECT_EQ(got.normalisation.current_A, sent.normalisation.current_A);
      EXPECT_EQ(got.model.a, sent.model.a);
      EXPECT_EQ(got.model.b, sent.model.b);
      EXPECT_EQ(control::closed_loop_spectral_radius(got.model, got, got.delay_ticks), sent.spectral_radius)
          << "worked out again from the same numbers";
    }
  }
}

}  // namespace supervisor_test
}  // namespace farrier::supervisor
