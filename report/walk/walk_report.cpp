// Pictures and page of a walk.

#include <Eigen/Geometry>
#include <cmath>

#include "body/model/posture.hpp"
#include "core/replace_file.hpp"
#include "core/units.hpp"
#include "report/figures/text_format.hpp"
#include "report/page/draw_pictures.hpp"
#include "report/page/html_page.hpp"
#include "report/page/html_tables.hpp"
#include "report/walk/moving_picture.hpp"
#include "report/walk/supply_section.hpp"
#include "report/walk/walk_run.hpp"

namespace farrier::report {
namespace {

constexpr std::size_t kMostPoints = 2000;
constexpr double kLastSecond_s = 1.0;
constexpr const char* kMovingPicture = "pictures/moving.svg";

/// A stretch of the run, in ticks; `step` of them give a point.
struct Stretch {
  std::span<const signals::BodyTruth> rows;
  std::size_t step;
};

Stretch whole(std::span<const signals::BodyTruth> truth) {
  return {truth, std::max<std::size_t>(1, truth.size() / kMostPoints)};
}

Stretch before_fall(std::span<const signals::BodyTruth> truth, double fell_s, double period_s) {
  const auto end = std::min(truth.size(), static_cast<std::size_t>(fell_s / period_s) + 1);
  const auto length = std::min(end, static_cast<std::size_t>(kLastSecond_s / period_s));
  return {truth.subspan(end - length, length), 1};
}

Panel trunk_panel(const Stretch& stretch, const WalkPlan& plan) {
  Series height{.label = "height, mm"}, wanted{.label = "wanted", .style = Style::kDashed, .colour = 5};
  for (std::size_t i = 0; i < stretch.rows.size(); i += stretch.step) {
    const double time_s = static_cast<double>(stretch.rows[i].tick) * plan.period_s;
    height.add(time_s, kMillimetres * plan.normal.dot(Eigen::Vector3d(stretch.rows[i].position_m.data())));
    wanted.add(time_s, kMillimetres * plan.height_m * plan.normal.z());
  }
  return {.y_label = "trunk's height, mm", .series = {height, wanted}};
}

Panel tilt_panel(const Stretch& stretch, const WalkPlan& plan) {
  Series tilt{.colour = 2};
  for (std::size_t i = 0; i < stretch.rows.size(); i += stretch.step) {
    const auto& row = stretch.rows[i];
    const Eigen::Quaterniond attitude(row.attitude[0], row.attitude[1], row.attitude[2], row.attitude[3]);
    tilt.add(static_cast<double>(row.tick) * plan.period_s,
             kDegrees * body::posture_of(Eigen::Vector3d(row.position_m.data()), attitude, plan.normal).tilt_rad);
  }
  return {.y_label = "tilt, degrees", .series = {tilt}};
}

Panel speed_panel(const Stretch& stretch, const WalkPlan& plan) {
  Series forward{.label = "forward", .colour = 1}, left{.label = "left", .colour = 2};
  Series asked{.label = "asked forward", .style = Style::kDashed, .colour = 5};
  for (std::size_t i = 0; i < stretch.rows.size(); i += stretch.step) {
    const auto& row = stretch.rows[i];
    const Eigen::Quaterniond attitude(row.attitude[0], row.attitude[1], row.attitude[2], row.attitude[3]);
    const Eigen::Vector3d velocity = attitude.conjugate() * Eigen::Vector3d(row.velocity_m_s.data());
    const double time_s = static_cast<double>(row.tick) * plan.period_s;
    forward.add(time_s, velocity.x());
    left.add(time_s, velocity.y());
    asked.add(time_s, time_s < plan.walk_s ? 0.0 : plan.forward_m_s);
  }
  return {.y_label = "velocity, m/s", .series = {forward, left, asked}};
}

Panel force_panel(const Stretch& stretch, const WalkPlan& plan, const robot::Robot& robot) {
  Panel panel{.x_label = "time, s", .y_label = "force of the ground, N"};
  for (std::size_t leg = 0; leg < robot.plan.legs.size(); ++leg) {
    Series force{.label = robot.plan.legs[leg].name, .colour = static_cast<int>(leg) + 1};
    for (std::size_t i = 0; i < stretch.rows.size(); i += stretch.step) {
      force.add(static_cast<double>(stretch.rows[i].tick) * plan.period_s,
                plan.normal.dot(Eigen::Vector3d(stretch.rows[i].foot_force_N.data() + 3 * leg)));
    }
    panel.series.push_back(force);
  }
  return panel;
}

std::string add(Drawing& drawing, const std::string& name, const std::string& caption, const Stretch& stretch,
                const WalkPlan& plan, const robot::Robot& robot) {
  const std::string path = drawing.add(name, {.caption = caption,
                                              .panels = {trunk_panel(stretch, plan), tilt_panel(stretch, plan),
                                                         speed_panel(stretch, plan), force_panel(stretch, plan, robot)},
                                              .key = Key::kAbove,
                                              .stacked = true});
  return image_html(path, caption);
}

/// The gains in three strides of the settled trot, or in the last second before a fall.
std::string add_gait(Drawing& drawing, const WalkRun& run) {
  constexpr double kStrides = 3.0;
  const std::optional<double>& fell_s = run.figures.fell_s;
  const double length_s = fell_s ? kLastSecond_s : kStrides / run.robot.plan.gait.frequency_Hz;
  const double end_s = fell_s.value_or(run.time_s(run.changes.rows.back().tick));
  const double settled_s = fell_s ? end_s : run.plan.walk_s + kWalkSettles_s;
  const double begin_s = std::max(0.0, std::min(settled_s, end_s - length_s));
  const auto tick_of = [&run](double time_s) { return static_cast<Tick>(std::llround(time_s / run.plan.period_s)); };
  const std::string caption = "plan, contact and acting gains of each leg, high in stance";
  const std::string path =
      drawing.add("gait", {.caption = caption,
                           .panels = gait_panels(run.robot, run.changes, tick_of(begin_s), tick_of(begin_s + length_s)),
                           .key = Key::kAbove,
                           .stacked = true});
  return image_html(path, caption);
}

}  // namespace

Result<std::string> write_walk_report(const std::string& out_dir, const Outcome& outcome, const WalkRun& run) {
  const WalkPlan& plan = run.plan;
  const WalkFigures& walk = run.figures;
  Drawing drawing(out_dir);
  std::string html = page_head(run.robot.name + ": " + outcome.command, outcome);
  html += "<p>The robot " + escape_html(walk_text(walk)) + ".</p>\n";
  if (const std::string moving = moving_picture(run); !moving.empty()) {
    FARRIER_TRY(replace_file(out_dir + "/" + kMovingPicture, moving));
    html += image_html(kMovingPicture, "the last seconds of the run, moving");
  }
  html += "<h2>Body</h2>\n";
  if (walk.fell_s) {
    html += add(drawing, "fall", "the last second before the fall", before_fall(run.truth, *walk.fell_s, plan.period_s),
                plan, run.robot);
  }
  html += add(drawing, "walk", "trunk and feet over the whole run", whole(run.truth), plan, run.robot);
  if (!run.changes.rows.empty()) {
    html += "<h2>Gains</h2>\n" + add_gait(drawing, run);
  }
  html += supply_section(drawing, run);
  if (auto drawn = drawing.draw(); !drawn) {
    return drawn.error();
  }
  html += page_foot(outcome);
  return write_page(out_dir, html);
}

}  // namespace farrier::report
