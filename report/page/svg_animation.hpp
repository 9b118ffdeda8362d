#pragma once

// Text of a moving SVG: numbers, lists of points, and values that change over a loop.

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

namespace farrier::report {

/// A number with at most one digit behind the point.
std::string svg_number(double value);

/// "x,y x,y ...".
std::string svg_points(std::span<const Eigen::Vector2d> points);

/// An attribute that moves through `values` at equal distances of time, from the first to the last, for ever. A browser
/// draws the straight line between two values unless `steps` says that they hold until the next.
std::string svg_animate(const std::string& attribute, std::span<const std::string> values, double loop_s,
                        bool steps = false);

/// The same for a translation; `values` are "x,y".
std::string svg_animate_translation(std::span<const std::string> values, double loop_s);

}  // namespace farrier::report
