#pragma once

#include <array>
#include <string>
#include <vector>

#include "monitor/frame.hpp"
#include "robot/robot.hpp"
#include "tools/monitor/table_view.hpp"

namespace farrier::display {

/// Emphasis of a line.
enum class Tone : std::uint8_t { kPlain, kHeading, kFaint, kWarning, kBad };

/// One joint in the table.
struct JointRow {
  const robot::Joint* joint;
  std::array<std::string, kColumnCount> cells;
  std::array<double, kColumnCount> keys;  ///< to sort by, not a number where nothing is known
  Tone tone;
};

/// Rows of the joints that the view's filter keeps, in its order. Unknown values come last in either direction. `frame`
/// is of `robot`.
std::vector<JointRow> joint_rows(const monitor::Frame& frame, const robot::Robot& robot, const TableView& view);

/// Replaces all but printable ASCII by "?": a process may report any bytes.
std::string printable(std::string_view text);

}  // namespace farrier::display
