#pragma once

#include <array>
#include <string>
#include <vector>

#include "monitor/frame.hpp"
#include "robot/robot.hpp"
#include "tools/monitor/table_view.hpp"

namespace farrier::display {

/// How much a line is to strike the eye.
enum class Tone : std::uint8_t { kPlain, kHeading, kFaint, kWarning, kBad };

/// One joint in the table.
struct JointRow {
  const robot::Joint* joint;
  std::array<std::string, kColumnCount> cells;
  std::array<double, kColumnCount> keys;  ///< to sort by, not a number where nothing is known
  Tone tone;
};

/// Rows of the joints that the view's filter leaves, in its order; what is not known comes last either way. `frame` is
/// of `robot`.
std::vector<JointRow> joint_rows(const monitor::Frame& frame, const robot::Robot& robot, const TableView& view);

/// With a "?" for all that is no printable ASCII: what a process says of itself may be anything.
std::string printable(std::string_view text);

}  // namespace farrier::display
