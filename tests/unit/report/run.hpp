#pragma once

// A run that never was: HyQ with force references and errors of known size.

#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/noise.hpp"
#include "gait/schedule.hpp"
#include "trace/trace.hpp"
#include "robot/robot.hpp"
#include "report/trot/tracking.hpp"

namespace farrier::report::testing {

inline constexpr std::uint64_t kSeed = 7;

inline robot::Robot hyq(const robot::Overrides& overrides = {}) {
  auto robot = robot::load_robot(std::string(FARRIER_ROBOTS) + "/hyq.yaml", overrides);
  FARRIER_ENSURE(robot.ok(), config::to_string(robot.error()).c_str());
  return std::move(robot).value();
}

/// Fills in reference and force; everything else of the row is there already.
using FillForces = std::function<void(const robot::Joint&, trace::TraceRow&)>;

/// Rows of all joints, tick by tick: joints swing sinusoidally by +-0.25 rad about home, commands are on time.
inline std::vector<trace::TraceRow> rows_of(const robot::Robot& robot, const gait::Schedule& schedule, Tick ticks,
                                            const FillForces& fill) {
  std::vector<trace::TraceRow> rows;
  rows.reserve(static_cast<std::size_t>(ticks) * robot.joints.size());
  for (Tick tick = 0; tick < ticks; ++tick) {
    for (const robot::Joint& joint : robot.joints) {
      const double angle =
          2.0 * std::numbers::pi * robot.plan.gait.frequency_Hz * static_cast<double>(tick) * robot.period_s;
      trace::TraceRow row;
      row.tick = tick;
      row.joint = joint.number;
      row.phase = schedule.phase(joint.leg, tick);
      row.position_m_or_rad = joint.linkage.position(joint.home_angle_rad + 0.25 * std::sin(angle));
      fill(joint, row);
      rows.push_back(row);
    }
  }
  return rows;
}

/// A reference like a trot's, and a force that lags it and rattles a little.
inline FillForces lagging_forces(const robot::Robot& robot, const gait::Schedule& schedule) {
  return [&robot, &schedule, noise = NoiseStream(kSeed, "report", "force")](const robot::Joint& joint,
                                                                            trace::TraceRow& row) {
    constexpr Tick kLagTicks = 4;
    const double rating = rating_of(robot, joint).force;
    const auto reference = [&](Tick tick) {
      const double progress = schedule.stance_progress(joint.leg, std::max<Tick>(0, tick));
      const double push = progress < 0.0 ? 0.0 : std::sin(std::numbers::pi * progress);
      return rating * (0.05 * std::sin(0.02 * static_cast<double>(tick)) - 0.4 * push);
    };
    row.force_reference_N_or_Nm = reference(row.tick);
    row.force_N_or_Nm = reference(row.tick - kLagTicks) + 0.003 * rating * noise.normal(row.tick * 16 + joint.number);
  };
}

/// A folder of its own for each test, gone when it ends.
class OwnFolder : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(path_); }
  void TearDown() override { std::filesystem::remove_all(path_); }

  const std::string path_ =
      (std::filesystem::temp_directory_path() / ("farrier_report_" + std::to_string(::getpid()) + "_" +
                                                 ::testing::UnitTest::GetInstance()->current_test_info()->name()))
          .string();
};

}  // namespace farrier::report::testing
