#pragma once

// A picture of a report as data. draw_pictures.hpp draws it.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace farrier::report {

enum class Style {
  kLine,
  kDashed,
  kSteps,
  kPoints,  ///< small discs
  kDiscs,
  kCrosses,
  kTriangles,
  kSquares,
  kPluses,
  kBand,       ///< filled from y to `high`
  kErrorBars,  ///< a point at y, a bar from `low` to `high`
  kBars,       ///< a horizontal bar from 0 to x at the height y, an interval from `low` to `high`
  kSpans,      ///< shaded from x to y of the x axis, behind the other series
};

struct Series {
  std::string label = {};              ///< for the key; empty: not in it. A series without points is only in the key.
  std::vector<double> x = {}, y = {};  ///< of one size; points that are not finite part a line
  Style style = Style::kLine;
  int colour = 0;                  ///< 0 black, 1 blue, 2 orange, 3 green, 4 purple, 5 grey; next ones repeat these
  std::vector<double> shade = {};  ///< by point, [0, 1], black to yellow; empty: `colour`
  std::vector<double> low = {}, high = {};  ///< by point, of the styles that name them

  void add(double point_x, double point_y) {
    x.push_back(point_x);
    y.push_back(point_y);
  }
};

struct Range {
  double from, to;
};

struct Panel {
  std::string title = {};
  std::string x_label = {}, y_label = {};
  bool log_x = false, log_y = false;
  bool unit_circle = false;  ///< draws it, with equal axes
  std::vector<Series> series = {};
  std::optional<Range> x_range = std::nullopt;  ///< of both axes with a unit circle; none: that of the data
  std::vector<std::string> rows = {};           ///< names of the heights 0, 1, ... in place of numbers
  std::optional<Range> y_range = std::nullopt;  ///< none: that of the data
};

enum class Key { kInside, kAbove, kBelow };

struct Picture {
  std::string caption = {};
  std::size_t columns = 1;  ///< panels side by side, filled row by row
  std::vector<Panel> panels = {};
  Key key = Key::kInside;
  bool stacked = false;  ///< panels of one column share the x axis, which the last one labels
  double width_px = 1080.0;
  double height_px = 0.0;  ///< 0: by the number of rows
};

}  // namespace farrier::report
