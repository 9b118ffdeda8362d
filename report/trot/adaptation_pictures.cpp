#include "report/trot/adaptation_pictures.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

#include "control/numerics/spectrum.hpp"
#include "robot/joint_model.hpp"
#include "supervisor/joint_design.hpp"

namespace farrier::report {
namespace {

using signals::JointControllerGains;
using signals::Phase;

// Stance is blue, swing is orange.
constexpr int kStance = 1;
constexpr int kSwing = 2;

/// One gain of one slot over time; the last value again at the end of the run.
Series gain_steps(const ReportInput& input, const robot::Joint& joint, Phase phase, double JointControllerGains::*gain,
                  double end_s) {
  std::vector<JointControllerGains> slot;
  std::ranges::copy_if(input.gains, std::back_inserter(slot), [&](const JointControllerGains& gains) {
    return gains.joint == joint.number && gains.phase == phase;
  });
  std::ranges::stable_sort(slot, {}, &JointControllerGains::effective_tick);
  Series steps{.label = phase == Phase::kStance ? "stance slot" : "swing slot",
               .style = Style::kSteps,
               .colour = phase == Phase::kStance ? kStance : kSwing};
  for (const JointControllerGains& gains : slot) {
    steps.add(static_cast<double>(gains.effective_tick) * input.robot.period_s, gains.*gain);
  }
  if (!slot.empty()) {
    steps.add(end_s, slot.back().*gain);
  }
  return steps;
}

/// One gain of both slots, and its values for the true loads.
Panel gain_panel(const ReportInput& input, const robot::Joint& joint, const char* name,
                 double JointControllerGains::*gain, double for_stance, double for_swing, double end_s) {
  const auto level = [&](double value, int colour) {
    return Series{.x = {0.0, end_s}, .y = {value, value}, .style = Style::kDashed, .colour = colour};
  };
  return {.y_label = name,
          .series = {level(for_stance, kStance),
                     level(for_swing, kSwing),
                     gain_steps(input, joint, Phase::kStance, gain, end_s),
                     gain_steps(input, joint, Phase::kSwing, gain, end_s),
                     {.label = "for the true load", .style = Style::kDashed, .colour = 5}},
          .x_range = Range{0.0, end_s}};
}

/// Poles of the estimates of one slot that were accepted, or not.
void add_estimates(Series& poles, const ReportInput& input, const robot::Joint& joint, Phase phase, bool accepted) {
  for (const DecisionInfo& info : input.outcome.run.decisions) {
    const signals::JointUpdateDecision& decision = info.decision;
    if (info.joint == joint.name && info.accepted() == accepted && decision.phase == phase) {
      for (std::size_t i = 0; i < decision.poles_re.size(); ++i) {
        if (decision.poles_re[i] != 0.0 || decision.poles_im[i] != 0.0) {  // the compliant form has two states
          poles.add(decision.poles_re[i], decision.poles_im[i]);
        }
      }
    }
  }
}

void add_true_poles(Series& series, const ReportInput& input, const robot::Joint& joint,
                    const plant::LoadParams& load) {
  const control::SmallMatrix a = robot::model_of(joint, load, input.robot.period_s).a;
  // The compliant form leaves the position out, and so do its estimates.
  const bool compliant = joint.form == control::Form::kCompliant;
  const auto poles = control::eigenvalues(compliant ? control::SmallMatrix(a.bottomRightCorner(2, 2)) : a);
  for (Eigen::Index i = 0; i < poles.size(); ++i) {
    series.add(poles[i].real(), poles[i].imag());
  }
}

}  // namespace

bool adapted(const ReportInput& input, const robot::Joint& joint) {
  return std::ranges::any_of(input.outcome.run.decisions,
                             [&](const DecisionInfo& info) { return info.joint == joint.name; });
}

Result<std::string> add_gains_picture(Drawing& drawing, const ReportInput& input, const robot::Joint& joint,
                                      double end_s) {
  const double period_s = input.robot.period_s;
  const auto stance = FARRIER_TRY(supervisor::design_joint(joint, joint.stance_load, period_s, input.loop_delay_ticks));
  const auto swing = FARRIER_TRY(supervisor::design_joint(joint, joint.swing_load, period_s, input.loop_delay_ticks));
  Panel velocity = gain_panel(input, joint, "velocity gain", &JointControllerGains::k_velocity, stance.velocity,
                              swing.velocity, end_s);
  Panel force =
      gain_panel(input, joint, "force gain", &JointControllerGains::k_force, stance.force, swing.force, end_s);
  force.x_label = "time / s";
  for (Series& series : force.series) {
    series.label.clear();
  }
  return drawing.add(joint.name + "_adaptation", {.panels = {std::move(velocity), std::move(force)},
                                                  .key = Key::kAbove,
                                                  .stacked = true,
                                                  .width_px = 640.0,
                                                  .height_px = 420.0});
}

std::string add_estimates_picture(Drawing& drawing, const ReportInput& input, const robot::Joint& joint) {
  Series stance{.label = "estimates accepted, stance", .style = Style::kPoints, .colour = kStance};
  Series swing{.label = "estimates accepted, swing", .style = Style::kPoints, .colour = kSwing};
  Series refused{.label = "estimates refused", .style = Style::kPluses, .colour = 5};
  Series true_stance{.label = "true, stance load", .style = Style::kSquares, .colour = kStance};
  Series true_swing{.label = "true, swing load", .style = Style::kTriangles, .colour = kSwing};
  add_estimates(stance, input, joint, Phase::kStance, true);
  add_estimates(swing, input, joint, Phase::kSwing, true);
  add_estimates(refused, input, joint, Phase::kStance, false);
  add_estimates(refused, input, joint, Phase::kSwing, false);
  add_true_poles(true_stance, input, joint, joint.stance_load);
  add_true_poles(true_swing, input, joint, joint.swing_load);
  constexpr double kRadius = 1.12;
  return drawing.add(joint.name + "_estimates",
                     pole_picture({stance, swing, refused, true_stance, true_swing}, kRadius));
}

Picture pole_picture(std::vector<Series> poles, double radius) {
  const double height_px = 395.0 + 25.0 * static_cast<double>(poles.size());  // the key has a line per series
  return {.panels = {{.x_label = "real part of z",
                      .y_label = "imaginary part of z",
                      .unit_circle = true,
                      .series = std::move(poles),
                      .x_range = Range{-radius, radius}}},
          .key = Key::kBelow,
          .width_px = 420.0,
          .height_px = height_px};
}

}  // namespace farrier::report
