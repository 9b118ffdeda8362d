#include "trials/body/adaptation_study.hpp"

#include <cmath>

#include "config/visitor.hpp"
#include "locomotion/motion_script.hpp"
#include "robot/sensor_path.hpp"

namespace farrier::trials {
namespace {

constexpr double kTrot_s = locomotion::kWalk_s;
constexpr double kSettle_s = 4.0;  // of walking before anything is judged or changes
constexpr double kWalk_s = 14.0;   // of a row without a drift
constexpr double kStrides = 3.0;   // after a step before figures begin

// `farrier compare adaptation --search` prints them.
constexpr control::FeedbackLinearisationGains kTunedGains{.force_1_s = 774.8,
                                                          .integral_1_s2 = 0.0,
                                                          .velocity_compensation = 0.6206,
                                                          .velocity_lead_s = 0.001922,
                                                          .swing_gain = 1.5};
constexpr double kObserver_1_s = 50.0;

control::FeedbackLinearisationGains observer_gains() noexcept {
  control::FeedbackLinearisationGains gains = kTunedGains;
  gains.observer_1_s = kObserver_1_s;
  return gains;
}

}  // namespace

bool is_lost(const TrotRow& run) noexcept {
  return !run.failure.empty() || run.figures.fell_s || run.figures.speed_error > kDoesNotWalk;
}

StudyDesign fixed_design(const robot::Robot& on_ground, const std::string& name, const std::string& sentence,
                         const control::FeedbackLinearisationGains& gains) {
  StudyDesign design{.name = name, .sentence = sentence, .robot = on_ground};
  for (robot::Joint& joint : design.robot.joints) {
    joint.kind = control::Kind::kFeedbackLinearisation;
    joint.feedback_linearisation = gains;
  }
  return design;
}

std::vector<StudyDesign> study_designs(const robot::Robot& on_ground, const robot::Robot& with_rls) {
  std::vector<StudyDesign> all;
  all.push_back({.name = kNominal, .sentence = "the file's design, fixed", .robot = on_ground});
  all.push_back(fixed_design(on_ground, kTuned, "one fixed design, searched over all rows", kTunedGains));
  all.push_back(fixed_design(on_ground, kObserver, "the same with a disturbance observer", observer_gains()));
  all.push_back(
      {.name = kThesis, .sentence = "LQR, redesigned from recursive least squares", .robot = with_rls, .adapts = true});
  for (robot::Joint& joint : all.back().robot.joints) {
    joint.kind = control::Kind::kLqr;
  }
  all.push_back({.name = kAdaptive,
                 .sentence = "the file's design with the valve that the estimator finds",
                 .robot = on_ground,
                 .adapts = true});
  all.push_back({.name = kPerfect,
                 .sentence = "the file's design with the true valve, overlap and leakage",
                 .robot = on_ground,
                 .knows = true});
  return all;
}

std::vector<StudyDesign> noise_designs(const robot::Robot& on_ground) {
  std::vector<StudyDesign> all;
  for (const int percent : {0, 10, 100, 300}) {
    all.push_back({.name = "noise_" + std::to_string(percent),
                   .sentence = "adaptive with " + std::to_string(percent) + " % of the sensors' noise",
                   .robot = robot::with_noise(on_ground, percent / 100.0),
                   .adapts = true});
  }
  return all;
}

robot::Robot with_gait(robot::Robot robot, const StudyCondition& condition) {
  if (condition.frequency_Hz > 0.0) {
    robot.plan.gait.frequency_Hz = condition.frequency_Hz;
    robot.plan.gait.duty = condition.duty;
  }
  return robot;
}

TrotCase study_case(const StudyDesign& design, const PlantRow& row, const StudyCondition& condition,
                    std::uint64_t seed) {
  using config::number_text;
  const double change_s = kTrot_s + kSettle_s;
  const double end_s = kTrot_s + kWalk_s + row.duration_s();
  const double frequency_Hz =
      condition.frequency_Hz > 0.0 ? condition.frequency_Hz : design.robot.plan.gait.frequency_Hz;
  const bool steps = row.later && row.duration_s() == 0.0;
  TrotCase one{
      .trial = std::string(row.name) + ", " + condition.name,
      .name = design.name + ", seed " + std::to_string(seed),
      .seed = seed,
      .scene = "friction: 0.8\n" + scene_of(row, design.robot, change_s),
      .script = locomotion::walk_script({.request = locomotion::Request::kTrot, .forward_m_s = condition.speed_m_s}),
      .adapts = design.adapts,
      .knows = design.knows,
      .trot_s = kTrot_s,
      .judged_from_s = change_s + (steps ? kStrides / frequency_Hz : 0.0),
      .judged_until_s = end_s,
      .end_s = end_s};
  if (condition.block_height_m > 0.0) {
    const double length_m = 1.0 + condition.speed_m_s * (end_s - kTrot_s);
    one.scene += "blocks: {field: {x_m: 0.8, y_m: -1.5, length_m: " + number_text(length_m) +
                 ", width_m: 3, size_m: 0.3, height_m: " + number_text(condition.block_height_m) +
                 ", seed: " + std::to_string(seed) + "}}\n";
  }
  return one;
}

double stance_nrmse(const ForceErrors& errors) noexcept {
  double squares = 0.0;
  for (const auto& of_place : errors) {
    const double error = of_place[static_cast<std::size_t>(Phase::kStance)];
    squares += error * error;
  }
  return std::sqrt(squares / static_cast<double>(errors.size()));
}

}  // namespace farrier::trials
