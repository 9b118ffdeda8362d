#pragma once

#include <optional>
#include <span>
#include <string>

#include "body/scene/scene.hpp"
#include "robot/robot.hpp"

namespace farrier::trials {

/// A plant that no design knows: from the start of a run, or with a change while the robot walks.
struct PlantRow {
  const char* name;                                          ///< of one word, as in figures
  const char* sentence;                                      ///< for people
  body::ActuatorChange first{};                              ///< from the start on; overlaps are those of HyQ's valves
  std::optional<body::ActuatorChange> later = std::nullopt;  ///< while it walks, over its duration
  bool first_leg = false;                                    ///< of the first leg alone
  double payload_kg = 0.0;                                   ///< on HyQ's trunk, of which the controllers do not know
  bool decides = false;                                      ///< more seeds: fixed designs fall here

  /// Time over which the later change grows, s; 0: a step, or none.
  double duration_s() const noexcept { return later ? later->duration_s : 0.0; }
};

/// The rows of `farrier compare adaptation`.
std::span<const PlantRow> plant_rows();

/// Sections of a scene that give a robot the row, of which a later state begins at `change_s`. Joints that are electric
/// have none.
std::string scene_of(const PlantRow& row, const robot::Robot& robot, double change_s);

}  // namespace farrier::trials
