#pragma once

#include <string>
#include <vector>

#include "diagnosis/separability/what_can_be_told.hpp"
#include "robot/robot.hpp"

namespace farrier::report {

/// Effects that a recording of a joint shows and tells apart, before any verdict: each alone, or those of a set.
struct ToldResult {
  diagnosis::WhatCanBeTold told = {};
  std::vector<diagnosis::ToldMember> set = {};  ///< empty: each effect alone
  robot::Robot robot;
  robot::Joint joint;
  std::string recording;
};

/// A table of effects, the pairs that are not told apart and what would tell them apart, the effects that do not show. For a
/// set: a table of its effects, what hides them and what would tell them.
std::string told_console(const ToldResult& result);

/// The same as JSON: "effects" with "name", "size", "change", "shows", "shows_from", "taken_for"; "pairs" with "one", "other", "left",
/// "column", "experiment"; "other_columns". For a set: "separable" and "set" with the same keys as "effects", "deviations",
/// "separable", "hidden_by", "column", "experiment".
std::string told_json(const ToldResult& result);

}  // namespace farrier::report
