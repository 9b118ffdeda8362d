#pragma once

#include <utility>

#include "robot/robot.hpp"
#include "tests/fuzz/harness.hpp"

namespace farrier::fuzz {

/// HyQ as it ships, with what a command line may change.
inline robot::Robot load_hyq(const std::string& estimator = {}, std::optional<control::Kind> kind = {}) {
  robot::Overrides overrides;
  overrides.controller = kind;
  if (!estimator.empty()) {
    overrides.estimator = estimator;
  }
  auto robot = robot::load_robot(FARRIER_ROBOTS "hyq.yaml", overrides);
  require(robot.ok(), "hyq.yaml loads");
  return std::move(robot).value();
}

inline const robot::Robot& hyq() {
  static const robot::Robot robot = load_hyq();
  return robot;
}

}  // namespace farrier::fuzz
