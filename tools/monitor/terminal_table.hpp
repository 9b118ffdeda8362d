#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/monitor/joint_row.hpp"

namespace farrier::display {

struct Line {
  std::string text;
  Tone tone = Tone::kPlain;
};

struct Table {
  std::vector<Line> lines;  ///< at most as many and as long as the view says
  int rows = 0;             ///< joints that the filter leaves
  int shown = 0;            ///< of those, as many as there is room for
};

/// Table of a frame of `robot` for a terminal: the run, its joints, its processes if there is room, and the newest of
/// `events`, which are in the order in which they came.
Table terminal_table(const monitor::Frame& frame, const robot::Robot& robot, std::span<const monitor::EventFrame> events,
                     const TableView& view);

/// The same as text, for output that is no terminal.
std::string text_of(const Table& table);

}  // namespace farrier::display
