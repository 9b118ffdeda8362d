#include "report/walk/moving_strips.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "report/page/html_tables.hpp"
#include "report/page/picture.hpp"
#include "report/page/svg_animation.hpp"

namespace farrier::report {
namespace moving_strips_parts {
namespace {

using Eigen::Vector2d;

constexpr double kTitle_px = 20.0, kGap_px = 12.0;
constexpr double kLeastStep = 0.1;  // of an axis, as labels have one digit behind the point
constexpr double kPointEvery_s = 0.01;
constexpr double kMilliampere = 1000.0;  // of an ampere

struct Line {
  std::string name;
  const char* colour;
  std::vector<double> times_s = {}, values = {};

  void add(double time_s, double value) {
    if (times_s.empty() || time_s >= times_s.back() + kPointEvery_s - 1e-9) {
      times_s.push_back(time_s);
      values.push_back(value);
    }
  }
};

struct Strip {
  std::string title;
  std::vector<Line> lines;
};

std::vector<Strip> strips_of(const WalkRun& run, const StripFrame& frame) {
  Line pressure{.name = "", .colour = "#0072b2"};
  Line pump{.name = "pump", .colour = "#1c2226"}, drawn{.name = "actuators", .colour = "#d55e00"};
  const auto shown = [&](double time_s) { return time_s >= frame.from_s && time_s <= frame.from_s + frame.loop_s; };
  for (const trace::SupplyRow& row : run.supply) {
    if (const double time_s = run.time_s(row.state.tick); shown(time_s)) {
      pressure.add(time_s, row.state.pressure_Pa / kPascalPerBar);
      pump.add(time_s, kLitrePerMinute * row.state.pump_flow_m3_s);
      drawn.add(time_s, kLitrePerMinute * row.state.flow_m3_s);
    }
  }
  const auto of_first_leg = [](const robot::Joint& joint) { return joint.leg == 0; };
  const auto found = std::find_if(run.robot.joints.rbegin(), run.robot.joints.rend(), of_first_leg);
  const robot::Joint& joint = found != run.robot.joints.rend() ? *found : run.robot.joints.front();
  Line a{.name = "A", .colour = "#0072b2"}, b{.name = "B", .colour = "#d55e00"},
      current{.name = "", .colour = "#009e73"};
  for (const trace::TraceRow& row : run.shown_joints(frame.loop_s)) {
    if (const double time_s = run.time_s(row.tick); row.joint == joint.number && shown(time_s)) {
      a.add(time_s, row.pressure_a_Pa / kPascalPerBar);
      b.add(time_s, row.pressure_b_Pa / kPascalPerBar);
      current.add(time_s, kMilliampere * row.valve_current_A);
    }
  }
  return {{"supply pressure, bar", {pressure}},
          {"flow, l/min", {drawn, pump}},
          {joint.name + ": chambers, bar", {a, b}},
          {joint.name + ": valve current, mA", {current}}};
}

/// Ends of an axis that all values lie between: multiples of 1, 2 or 5 times a power of ten.
Range ends_of(const Strip& strip) {
  double low = 0.0, high = 0.0;
  bool first = true;
  for (const Line& line : strip.lines) {
    for (const double value : line.values) {
      low = first ? value : std::min(low, value);
      high = first ? value : std::max(high, value);
      first = false;
    }
  }
  const double third = std::max((high - low) / 3.0, kLeastStep);
  const double decade = std::pow(10.0, std::floor(std::log10(third)));
  const double step = third >= 5.0 * decade ? 5.0 * decade : third >= 2.0 * decade ? 2.0 * decade : decade;
  const Range ends{step * std::floor(low / step), step * std::ceil(high / step)};
  return ends.to > ends.from ? ends : Range{ends.from - step, ends.to + step};
}

std::string draw(const Strip& strip, const StripFrame& frame, double top_px, double bottom_px) {
  const Range ends = ends_of(strip);
  const auto y = [&](double value) {
    return bottom_px - (bottom_px - top_px) * (value - ends.from) / (ends.to - ends.from);
  };
  const auto label = [&](double value, double shift_px) {
    return "<text class=\"faint\" text-anchor=\"end\" x=\"" + svg_number(frame.left_px - 6.0) + "\" y=\"" +
           svg_number(y(value) + shift_px) + "\">" + svg_number(value) + "</text>";
  };
  std::string svg = "<text x=\"" + svg_number(frame.left_px) + "\" y=\"" + svg_number(top_px - 6.0) + "\">" +
                    escape_html(strip.title);
  for (const Line& line : strip.lines) {
    svg += line.name.empty() ? ""
                             : "<tspan dx=\"10\" fill=\"" + std::string(line.colour) + "\">— " + line.name + "</tspan>";
  }
  svg += "</text><rect x=\"" + svg_number(frame.left_px) + "\" y=\"" + svg_number(top_px) + "\" width=\"" +
         svg_number(frame.right_px - frame.left_px) + "\" height=\"" + svg_number(bottom_px - top_px) +
         "\" fill=\"#f6f8f9\"/>" + label(ends.to, 10.0) + label(ends.from, 0.0) + "\n";
  for (const Line& line : strip.lines) {
    std::vector<Vector2d> points;
    for (std::size_t i = 0; i < line.values.size(); ++i) {
      points.emplace_back(
          frame.left_px + (frame.right_px - frame.left_px) * (line.times_s[i] - frame.from_s) / frame.loop_s,
          y(line.values[i]));
    }
    svg += "<polyline points=\"" + svg_points(points) + "\" fill=\"none\" stroke=\"" + line.colour +
           "\" stroke-width=\"1.3\"/>\n";
  }
  return svg;
}

}  // namespace
}  // namespace moving_strips_parts

std::string moving_strips(const WalkRun& run, const StripFrame& frame) {
  using namespace moving_strips_parts;
  const std::vector<Strip> strips = strips_of(run, frame);
  const double each_px = (frame.bottom_px - frame.top_px + kGap_px) / static_cast<double>(strips.size());
  std::string svg;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const double top_px = frame.top_px + static_cast<double>(i) * each_px;
    svg += draw(strips[i], frame, top_px + kTitle_px, top_px + each_px - kGap_px);
  }
  const std::array<std::string, 2> ends{svg_number(frame.left_px) + ",0", svg_number(frame.right_px) + ",0"};
  return svg + "<g><path d=\"M0," + svg_number(frame.top_px + kTitle_px) + "V" + svg_number(frame.bottom_px) +
         "\" stroke=\"#1c2226\" stroke-width=\"1\"/>" + svg_animate_translation(ends, frame.loop_s) + "</g>\n";
}

}  // namespace farrier::report
