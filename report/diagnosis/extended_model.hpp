#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "plant/terms/active_effect.hpp"
#include "robot/robot.hpp"

namespace farrier::report {

struct ExtendedModel {
  std::string text;                   ///< of the robot file; empty: it has a place for none of the effects
  std::optional<robot::Robot> robot;  ///< that the text loads to; none without a text
  std::vector<std::string> left_out;  ///< effects without a place in it, or why the file does not load, a sentence each
};

/// The robot file, defaults filled in, with these effects of a joint. Those of a hydraulic one are in its section
/// `effects`, where one that the joint has already gets the new numbers. Those of an electric one are in the values of its
/// drive and load (put_into_drive_and_load()). Refuses with the reader's problems effects of a hydraulic joint that do not
/// load again.
Result<ExtendedModel> extended_model(const robot::Robot& robot, const robot::Joint& joint,
                                     std::span<const plant::ActiveEffect> found);

/// Puts effects of an electric joint into the values of its drive and its load; a drive or a load that other joints
/// have too is copied first. Returns the reasons why effects are left out, a sentence each: a robot file has no value
/// for them.
std::vector<std::string> put_into_drive_and_load(robot::RobotFile& file, const robot::Joint& joint,
                                                 std::span<const plant::ActiveEffect> effects);

}  // namespace farrier::report
