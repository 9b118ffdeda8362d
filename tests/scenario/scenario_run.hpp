#pragma once

// Whole runs over the in-process bus, with what they wrote.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/fault.hpp"
#include "run/inproc_run.hpp"
#include "trace/trace.hpp"
#include "robot/keys.hpp"

namespace farrier::scenario {

inline robot::Robot load(const std::string& name, const robot::Overrides& overrides = {}) {
  auto robot = robot::load_robot(std::string(FARRIER_ROBOTS) + name + ".yaml", overrides);
  FARRIER_ENSURE(robot.ok(), config::to_string(robot.error()).c_str());
  return std::move(robot).value();
}

/// Touchdowns up to `jitter_s` early or late; gains change exactly as announced, without the file's stance lead.
inline robot::Robot load_with_jitter(const std::string& name, double jitter_s) {
  robot::Robot robot = load(name);
  robot.plan.gait.touchdown_jitter_s = jitter_s;
  robot.safety.stance_lead_s = 0.0;
  FARRIER_ENSURE(gait::validate(robot.plan).ok(), "a jitter below the announcement");
  return robot;
}

struct Outcome {
  std::string trace;                   ///< its bytes
  std::vector<trace::TraceRow> rows;  ///< tick by tick, joint by joint
  run::InprocResult result;

  const trace::TraceRow& at(Tick tick, std::size_t joint, std::size_t joints) const {
    return rows.at(static_cast<std::size_t>(tick) * joints + joint);
  }
};

/// Runs to the end; a run that is refused or stalls fails the test and gives nothing.
inline Outcome run(const robot::Robot& robot, run::InprocRun settings) {
  static int runs = 0;
  settings.trace_path = (std::filesystem::temp_directory_path() /
                         ("farrier_scenario_" + std::to_string(::getpid()) + "_" + std::to_string(++runs) + ".csv"))
                            .string();
  auto result = run::run_inproc(robot, settings);
  Outcome outcome;
  if (!result) {
    ADD_FAILURE() << result.error().message;
  } else {
    outcome.result = std::move(result).value();
    std::ostringstream bytes;
    bytes << std::ifstream(settings.trace_path).rdbuf();
    outcome.trace = bytes.str();
    auto rows = trace::read_trace(settings.trace_path, robot::joint_names(robot));
    EXPECT_TRUE(rows.ok()) << (rows ? "" : rows.error().message);
    EXPECT_EQ(rows.value().size(), static_cast<std::size_t>(settings.ticks) * robot.joints.size());
    outcome.rows = std::move(rows).value();
  }
  std::filesystem::remove(settings.trace_path);
  return outcome;
}

}  // namespace farrier::scenario
