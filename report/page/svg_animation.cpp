#include "report/page/svg_animation.hpp"

#include <cmath>
#include <cstdio>

namespace farrier::report {
namespace svg_animation_parts {
namespace {

std::string timing(std::span<const std::string> values, double loop_s) {
  std::string text = " dur=\"" + svg_number(loop_s) + "s\" repeatCount=\"indefinite\" values=\"";
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += (i == 0 ? "" : ";") + values[i];
  }
  return text + "\"/>";
}

}  // namespace
}  // namespace svg_animation_parts

std::string svg_number(double value) {
  const double rounded = std::round(10.0 * value) / 10.0;
  char text[32];
  std::snprintf(text, sizeof text, rounded == std::round(rounded) ? "%.0f" : "%.1f", rounded == 0.0 ? 0.0 : rounded);
  return text;
}

std::string svg_points(std::span<const Eigen::Vector2d> points) {
  std::string text;
  for (const Eigen::Vector2d& point : points) {
    text += (text.empty() ? "" : " ") + svg_number(point.x()) + "," + svg_number(point.y());
  }
  return text;
}

std::string svg_animate(const std::string& attribute, std::span<const std::string> values, double loop_s, bool steps) {
  return "<animate attributeName=\"" + attribute + "\"" + (steps ? " calcMode=\"discrete\"" : "") +
         svg_animation_parts::timing(values, loop_s);
}

std::string svg_animate_translation(std::span<const std::string> values, double loop_s) {
  return "<animateTransform attributeName=\"transform\" type=\"translate\"" +
         svg_animation_parts::timing(values, loop_s);
}

}  // namespace farrier::report
