// Fifty summaries a second of what a joint measured.

#include "joint_node/summariser.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/fault.hpp"

namespace farrier::joint_node {
namespace summariser_test {

using signals::JointMeasurement;
using signals::JointState;

JointMeasurement measured(Tick tick, double reference_N = 300.0, double force_N = 296.0) {
  return {.joint = 4,
          .tick = tick,
          .position_m_or_rad = 0.001 * static_cast<double>(tick),
          .force_N_or_Nm = force_N,
          .force_reference_N_or_Nm = reference_N,
          .state = JointState::kTracking};
}

TEST(SummariserTest, SumsUpEveryTwentyTicksAtOneKilohertz) {
  Summariser summariser(1e-3);
  for (Tick tick = 0; tick < 20; ++tick) {
    EXPECT_FALSE(summariser.take(measured(tick, 300.0, tick % 2 == 0 ? 297.0 : 304.0))) << tick;
  }
  const auto summary = summariser.take(measured(20));
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->joint, 4);
  EXPECT_EQ(summary->tick, 19);
  EXPECT_EQ(summary->ticks, 20);
  EXPECT_DOUBLE_EQ(summary->position_m_or_rad, 0.019);
  EXPECT_DOUBLE_EQ(summary->force_error_rms_N_or_Nm, std::sqrt(0.5 * (9.0 + 16.0)));
  EXPECT_DOUBLE_EQ(summary->force_reference_rms_N_or_Nm, 300.0);
}

TEST(SummariserTest, JointsOfDifferentTurnsTellInDifferentTicks) {
  Summariser first(1e-3, 4), second(1e-3, 25);  // 25 is the turn of 5, every twenty ticks
  for (Tick tick = 0; tick < 60; ++tick) {
    EXPECT_EQ(first.take(measured(tick)).has_value(), tick % 20 == 16) << tick;
    EXPECT_EQ(second.take(measured(tick)).has_value(), tick % 20 == 15) << tick;
  }
}

TEST(SummariserTest, SumsUpEveryTickWhereTheLoopIsSlow) {
  Summariser summariser(0.1);
  EXPECT_FALSE(summariser.take(measured(0)));
  const auto summary = summariser.take(measured(1));
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->tick, 0);
  EXPECT_EQ(summary->ticks, 1);
}

TEST(SummariserTest, HidesNoFaultAndNoCareOfAnyTick) {
  Summariser summariser(1e-3);
  for (Tick tick = 0; tick < 20; ++tick) {
    JointMeasurement m = measured(tick);
    if (tick == 7) {
      m.faults = static_cast<std::uint32_t>(Fault::kForceLost);
      m.state = JointState::kDamping;
    }
    summariser.take(m);
  }
  const auto summary = summariser.take(measured(20));
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->faults, static_cast<std::uint32_t>(Fault::kForceLost));
  EXPECT_EQ(summary->state, JointState::kDamping);
}

TEST(SummariserTest, CountsWhatItGotWhereTicksAreMissing) {
  Summariser summariser(1e-3);
  for (const Tick tick : {0, 1, 2, 17}) {
    EXPECT_FALSE(summariser.take(measured(tick)));
  }
  const auto summary = summariser.take(measured(45));
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->tick, 17);
  EXPECT_EQ(summary->ticks, 4);
}

TEST(SummariserTest, TellsWhatAJointDoesThatHearsNothing) {
  Summariser summariser(1e-3);
  for (Tick tick = 0; tick < 5; ++tick) {
    EXPECT_FALSE(summariser.take(measured(tick)));
  }
  JointMeasurement stale = measured(4, 0.0, 250.0);
  stale.faults = static_cast<std::uint32_t>(Fault::kSensorsStale);
  stale.state = JointState::kNull;
  std::vector<signals::JointSummary> told;
  for (int i = 0; i < 60; ++i) {
    if (const auto summary = summariser.take(stale)) {
      told.push_back(*summary);
    }
  }
  ASSERT_EQ(told.size(), 3u);  // fifty a second still
  EXPECT_EQ(told[0].ticks, 5);
  EXPECT_DOUBLE_EQ(told[0].force_error_rms_N_or_Nm, 4.0);
  for (const signals::JointSummary& summary : told) {
    EXPECT_EQ(summary.tick, 4);
    EXPECT_EQ(summary.faults, stale.faults);
    EXPECT_EQ(summary.state, stale.state);
  }
  EXPECT_EQ(told[1].ticks, 0);
  EXPECT_EQ(told[1].force_error_rms_N_or_Nm, 0.0);
  EXPECT_EQ(told[2].ticks, 0);
}

TEST(SummariserTest, CountsAMeasurementToldTwiceOnce) {
  Summariser summariser(1e-3);
  for (Tick tick = 0; tick < 20; ++tick) {
    EXPECT_FALSE(summariser.take(measured(tick)));
    EXPECT_FALSE(summariser.take(measured(tick)));
  }
  const auto summary = summariser.take(measured(20));
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->tick, 19);
  EXPECT_EQ(summary->ticks, 20);
}

TEST(SummariserTest, IsSilentBeforeTheFirstTick) {
  Summariser summariser(1e-3);
  for (int i = 0; i < 50; ++i) {
    EXPECT_FALSE(summariser.take(measured(kNoTick)));
  }
  for (Tick tick = 0; tick < 20; ++tick) {
    EXPECT_FALSE(summariser.take(measured(tick)));
  }
  EXPECT_EQ(summariser.take(measured(20))->ticks, 20);
}

}  // namespace summariser_test
}  // namespace farrier::joint_node
