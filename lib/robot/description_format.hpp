#pragma once

#include <optional>
#include <string>

#include "config/problem.hpp"

namespace farrier::robot {

/// The problem of a text that is a robot's description of another kind (URDF, xacro, SDF, MJCF) and no robot file. Its
/// message says what the text is and how to write a robot file from it; of a URDF it lists the limits of the joints. None
/// for every other text.
std::optional<config::Problem> foreign_description(const std::string& text, const std::string& file);

}  // namespace farrier::robot
