#include "thesis/rig/filter_study.hpp"

#include <cmath>

#include "run/inproc_run.hpp"
#include "robot/robot_builder.hpp"

namespace farrier::thesis {
namespace {

constexpr double kTransient_s = 0.2;

/// Judges a run row by row.
class Judge {
 public:
  explicit Judge(Tick from) : from_(from) {}

  void take(const trace::TraceRow& row) {
    if (row.tick >= from_) {
      const double error = row.force_reference_N_or_Nm - row.force_N_or_Nm;
      const double change = row.valve_current_A - current_A_;
      errors_ += error * error;
      references_ += row.force_reference_N_or_Nm * row.force_reference_N_or_Nm;
      changes_ += change * change;
      ++ticks_;
      clean_ = clean_ && row.faults == 0;
    }
    current_A_ = row.valve_current_A;
  }
  void tell(FilterRow& row) const {
    row.nrmse = std::sqrt(errors_ / references_);
    row.current_step_rms_A = std::sqrt(changes_ / static_cast<double>(ticks_));
    row.stayed_armed = clean_;
  }

 private:
  Tick from_;
  double errors_ = 0.0, references_ = 0.0, changes_ = 0.0, current_A_ = 0.0;
  Tick ticks_ = 0;
  bool clean_ = true;
};

Result<robot::Robot> standing(const robot::Robot& rig) {
  robot::RobotFile file = rig.file;
  file.gait.pattern = gait::Pattern::kStand;
  auto built = robot::build_robot(std::move(file));
  if (!built) {
    return Error{config::to_string(built.error())};
  }
  robot::Robot robot = std::move(built).value();
  robot.joints[0].dither_percent = 0.0;
  return robot;
}

robot::Robot with_filter(robot::Robot robot, const FilterCase& filter) {
  robot::Sensors& sensors = robot.joints[0].sensors;
  sensors.velocity.cut_off_Hz = filter.velocity_cut_off_Hz;
  sensors.velocity.order = filter.order;
  sensors.oversampling = filter.oversampled ? kStudyConversions : 1;
  sensors.anti_alias.cut_off_Hz = filter.oversampled ? kStudyAntiAlias_Hz : 0.0;
  return robot;
}

Result<FilterRow> run_case(const robot::Robot& rig, const FilterCase& filter, bool heavy, double duration_s,
                           std::uint64_t seed) {
  const robot::Robot world = with_filter(rig, filter);
  const robot::Joint& joint = world.joints[0];
  const auto coefficients = control::design_low_pass(joint.sensors.velocity, 1.0 / rig.period_s);
  if (!coefficients) {
    return Error{"a velocity filter of order " + std::to_string(filter.order) + " with cut-off " +
                 config::number_text(filter.velocity_cut_off_Hz) +
                 " Hz: give order 1 or 2 and a cut-off of 0 or within " + config::number_text(control::kLargestCutOffShare / rig.period_s) + " Hz"};
  }
  FilterRow row{.filter = filter, .velocity_filter = *coefficients, .gains = {}};
  row.load_mass_kg = heavy ? joint.stance_load.mass : joint.swing_load.mass;
  row.conversion_delay_ticks = 0.5 * (1.0 - 1.0 / joint.sensors.oversampling);

  const double lead_in_s = rig.plan.gait.lead_in_s;
  Judge judge(run::ticks_of(lead_in_s + kTransient_s, rig));
  run::InprocRun run;
  run.ticks = run::ticks_of(lead_in_s + duration_s, rig);
  run.seed = seed;
  run.design = heavy ? supervisor::Design::kStance : supervisor::Design::kSwing;
  run.load_changes = {{0, joint.number, heavy ? joint.stance_load : joint.swing_load}};
  run.simulated = &world;
  run.sink = [&judge](const trace::TraceRow& at) { judge.take(at); };
  auto result = FARRIER_TRY(run::run_inproc(rig, run));
  judge.tell(row);
  if (!result.gains.empty()) {
    row.gains = result.gains.back();
  }
  return row;
}

}  // namespace

std::vector<FilterCase> filter_cases() {
  std::vector<FilterCase> cases;
  for (const bool oversampled : {false, true}) {
    cases.push_back({0.0, 2, oversampled});
    for (const int order : {1, 2}) {
      for (const double cut_off_Hz : {400.0, 200.0, 100.0, 50.0}) {
        cases.push_back({cut_off_Hz, order, oversampled});
      }
    }
  }
  return cases;
}

Result<std::vector<FilterRow>> filter_study(const robot::Robot& rig, const std::vector<FilterCase>& cases,
                                            double duration_s, std::uint64_t seed) {
  if (rig.joints.size() != 1 || rig.plan.gait.reference != gait::ReferenceKind::kMultisine) {
    return Error{rig.name + ": the filter study is for a rig with one joint and a multisine, such as fc1d"};
  }
  if (!(duration_s > kTransient_s && duration_s <= 60.0)) {
    return Error{"the filter study's duration must be above 0.2 s and at most 60 s"};
  }
  const auto stand = FARRIER_TRY(standing(rig));
  std::vector<FilterRow> rows;
  for (const FilterCase& filter : cases) {
    for (const bool heavy : {false, true}) {
      auto row = FARRIER_TRY(run_case(stand, filter, heavy, duration_s, seed));
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace farrier::thesis
