// Touchdown and lift-off of the simulated legs.

#include "tests/unit/sim_bridge/sim_world_bench.hpp"

namespace farrier::sim_bridge {
namespace sim_world_contact_test {

using namespace testing;
using gait::Phase;

constexpr double kJitter_s = 0.010;

robot::Robot with_jitter(const std::string& name) {
  robot::Robot robot = robot::load_shipped(name);
  robot.plan.gait.touchdown_jitter_s = kJitter_s;
  EXPECT_TRUE(gait::validate(robot.plan));
  return robot;
}

/// Planned switches of a leg within the first `ticks`.
std::vector<gait::PhaseSwitch> plan_of(const gait::Schedule& schedule, int leg, Tick ticks) {
  std::vector<gait::PhaseSwitch> switches;
  for (Tick tick = 0; tick < ticks; ++tick) {
    if (const auto planned = schedule.announcement(leg, tick)) {
      switches.push_back(*planned);
    }
  }
  return switches;
}

// Two runs that differ in nothing but the tick of a touchdown: when the first of them touches down, its mass jumps
// and its motion goes on from the very same state.
TEST(SimWorld, KeepsItsVelocityWhenTheMassJumpsAtTouchdown) {
  const robot::Robot rig = with_jitter("fc1d");
  const gait::Schedule schedule(rig.plan, 1);
  const gait::PhaseSwitch touchdown = plan_of(schedule, 0, 3000).at(1);
  ASSERT_EQ(touchdown.phase, Phase::kStance);
  std::uint64_t other_seed = 2;
  while (gait::Schedule(rig.plan, other_seed).actual_switch(0, touchdown) == schedule.actual_switch(0, touchdown)) {
    ++other_seed;
  }
  SimWorld one = world_of(rig, 1);
  SimWorld other = world_of(rig, other_seed);
  const std::vector<double> opening{0.002};  // keeps the piston moving
  const auto masses_differ = [&] {
    return row_of(one, 0).load_mass_kg_or_kgm2 != row_of(other, 0).load_mass_kg_or_kgm2;
  };
  while (!masses_differ()) {
    ASSERT_LT(one.tick(), 3000) << "no touchdown";
    // Back and forth about mid-stroke, fast when the leg lands.
    const bool forth = (one.tick() - touchdown.tick + 10'000) % 40 < 20;
    const std::vector<double> currents{forth ? opening[0] : -opening[0]};
    one.advance(currents);
    other.advance(currents);
  }
  EXPECT_TRUE(same_state(row_of(one, 0), row_of(other, 0))) << "the state jumped with the mass";
  EXPECT_GT(std::abs(row_of(one, 0).velocity_m_s_or_rad_s), 1e-3) << "at rest the test says nothing";
  one.advance(opening);
  other.advance(opening);
  EXPECT_FALSE(same_state(row_of(one, 0), row_of(other, 0))) << "the mass made no difference";
}

class Trotting : public ::testing::Test {
 protected:
  static constexpr Tick kTicks = 2200;

  const robot::Robot robot_ = with_jitter("hyq");
  const gait::Schedule schedule_{robot_.plan, 1};
  SimWorld world_ = world_of(robot_, 1);
};

TEST_F(Trotting, TouchesDownWithinTheJitterOfThePlanAndLiftsOffOnTime) {
  std::vector<std::vector<Tick>> switched(robot_.plan.legs.size());
  std::vector<Phase> phase(robot_.plan.legs.size(), Phase::kStance);
  for (; world_.tick() < kTicks; world_.advance(shut(world_))) {
    for (const robot::Joint& joint : robot_.joints) {
      const auto leg = static_cast<std::size_t>(joint.leg);
      const auto row = row_of(world_, joint.number);
      if (joint.index_in_leg == 0 && row.actual_phase != phase[leg]) {
        phase[leg] = row.actual_phase;
        switched[leg].push_back(row.tick);
      }
      EXPECT_EQ(row.actual_phase, phase[leg]) << "joints of a leg switch together";
    }
  }
  const Tick jitter = schedule_.jitter_ticks();
  ASSERT_EQ(jitter, 10);
  bool some_late = false;
  for (std::size_t leg = 0; leg < switched.size(); ++leg) {
    const auto planned = plan_of(schedule_, static_cast<int>(leg), kTicks - 100);
    ASSERT_GE(switched[leg].size(), 3u);
    for (std::size_t i = 0; i < std::min(planned.size(), switched[leg].size()); ++i) {
      const Tick late = switched[leg][i] - planned[i].tick;
      if (planned[i].phase == Phase::kStance) {
        EXPECT_LE(std::abs(late), jitter);
        some_late = some_late || late != 0;
      } else {
        EXPECT_EQ(late, 0);
      }
    }
  }
  EXPECT_TRUE(some_late) << "the jitter does nothing";
}

TEST_F(Trotting, PutsWeightOnALegOnlyWhileItStands) {
  std::vector<Tick> since_touchdown(robot_.plan.legs.size(), 0);
  int carried = 0;
  for (; world_.tick() < kTicks; world_.advance(shut(world_))) {
    for (const robot::Joint& joint : robot_.joints) {
      const auto row = row_of(world_, joint.number);
      const auto leg = static_cast<std::size_t>(joint.leg);
      const bool stands = row.actual_phase == Phase::kStance;
      if (joint.index_in_leg == 0) {
        since_touchdown[leg] = stands ? since_touchdown[leg] + 1 : 0;
      }
      if (!stands) {
        EXPECT_EQ(row.external_force_N_or_Nm, 0.0) << joint.name << " at tick " << row.tick;
      } else if (joint.index_in_leg == 2) {
        // Knees carry; the load comes in from the first tick on, too softly to show at once.
        carried += row.external_force_N_or_Nm != 0.0 ? 1 : 0;
        if (since_touchdown[leg] == schedule_.stance_ticks() / 2 && row.tick > schedule_.lead_in_ticks()) {
          EXPECT_GT(std::abs(row.external_force_N_or_Nm), 100.0) << joint.name << " at tick " << row.tick;
        }
      }
    }
  }
  EXPECT_GT(carried, 1000);
}

TEST_F(Trotting, ChangesTheMassWithThePhase) {
  for (; world_.tick() < kTicks; world_.advance(shut(world_))) {
    for (const robot::Joint& joint : robot_.joints) {
      const auto row = row_of(world_, joint.number);
      const bool stands = row.actual_phase == Phase::kStance;
      ASSERT_EQ(row.load_mass_kg_or_kgm2, stands ? joint.stance_load.mass : joint.swing_load.mass);
    }
  }
}

}  // namespace sim_world_contact_test
}  // namespace farrier::sim_bridge
