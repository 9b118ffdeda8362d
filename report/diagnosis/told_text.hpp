#pragma once

#include <string>

#include "diagnosis/judge/what_can_be_told.hpp"
#include "robot/robot.hpp"

namespace farrier::report {

/// Effects that a recording of a joint shows and tells apart, before any verdict.
struct ToldResult {
  diagnosis::WhatCanBeTold told;
  robot::Robot robot;
  robot::Joint joint;
  std::string recording;
};

/// A table of effects, the pairs that are not told apart and what would tell them apart, the effects that do not show.
std::string told_console(const ToldResult& result);

/// The same as JSON: "effects" with "name", "size", "change", "shows", "shows_from", "taken_for"; "pairs" with "one", "other", "left",
/// "column", "experiment"; "other_columns".
std::string told_json(const ToldResult& result);

}  // namespace farrier::report
