// farrier compare filters: margins behind sensors that filter, and what the joint's node can make good of them.

#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "cli/base/command.hpp"
#include "cli/base/installation.hpp"
#include "cli/base/progress.hpp"
#include "cli/compare/comparison.hpp"
#include "control/design/margins.hpp"
#include "core/noise.hpp"
#include "participant/loop.hpp"
#include "report/compare/filters.hpp"
#include "report/figures/console.hpp"
#include "report/figures/text_format.hpp"
#include "robot/joint_model.hpp"
#include "robot/sensor_path.hpp"
#include "trials/load_cycle.hpp"
#include "trials/loop_stability.hpp"

namespace farrier::cli {
namespace {

using report::FilterChecks;
using report::FilterRow;
using trials::RunningLoop;

constexpr int kSets = 100;

/// A joint and a load of it that the table has.
struct Subject {
  std::string name;
  robot::Joint joint;
  plant::LoadParams load;
  double period_s;
};

/// Cut-offs of a row of the table, of second order, Hz; 0: none.
struct FilterCase {
  const char* name;
  double position_Hz, velocity_Hz, force_Hz;
};
constexpr std::array kCases{FilterCase{"none", 0, 0, 0},
                            FilterCase{"all 100 Hz", 100, 100, 100},
                            FilterCase{"velocity 100 Hz", 0, 100, 0},
                            FilterCase{"force 100 Hz", 0, 0, 100},
                            FilterCase{"force 150 Hz", 0, 0, 150},
                            FilterCase{"force 100 Hz, velocity 300 Hz", 0, 300, 100},
                            FilterCase{"all 50 Hz", 50, 50, 50}};

std::vector<Subject> subjects_of(const robot::Robot& rig, const robot::Robot& robot) {
  std::vector<Subject> subjects;
  for (const double mass_kg : {trials::kLightMass_kg, 2.5, trials::kHeavyMass_kg}) {
    plant::LoadParams load = rig.joints[0].swing_load;
    load.mass = mass_kg;
    subjects.push_back({"fc1d " + report::short_number(mass_kg) + " kg", rig.joints[0], load, rig.period_s});
  }
  for (const robot::Joint& joint : robot.joints) {
    if (joint.leg == 0) {
      subjects.push_back({joint.name + " swing", joint, joint.swing_load, robot.period_s});
      subjects.push_back({joint.name + " stance", joint, joint.stance_load, robot.period_s});
    }
  }
  return subjects;
}

Result<control::Gains> design(const Subject& subject, int delay_ticks) {
  const robot::Joint& joint = subject.joint;
  const auto gains = control::design(robot::model_of(joint, subject.load, subject.period_s), joint.design,
                                     joint.normalisation, joint.form, delay_ticks, subject.period_s);
  return gains ? Result<control::Gains>(gains.value())
               : Result<control::Gains>(Error{subject.name + ": " + control::to_string(gains.error())});
}

control::Margins margins_behind_filters(const Subject& subject, const control::Gains& gains) {
  return control::margins(gains.model, gains, gains.delay_ticks,
                          robot::measurement_filters(subject.joint, subject.period_s));
}

Result<std::vector<FilterRow>> table_of(const std::vector<Subject>& subjects) {
  std::vector<FilterRow> rows;
  for (const Subject& subject : subjects) {
    const auto gains = FARRIER_TRY(design(subject, 0));
    for (const FilterCase& one : kCases) {
      Subject filtered = subject;
      filtered.joint.sensors.position.cut_off_Hz = one.position_Hz;
      filtered.joint.sensors.velocity.cut_off_Hz = one.velocity_Hz;
      filtered.joint.sensors.force.cut_off_Hz = one.force_Hz;
      filtered.joint.equalises_filters = false;
      const double disk = margins_behind_filters(filtered, gains).disk;
      filtered.joint.equalises_filters = true;
      rows.push_back({subject.name, one.name, disk, margins_behind_filters(filtered, gains).disk});
    }
  }
  return rows;
}

/// Draws the filters of a set, and makes the valve and the oil the same both ways: the linear model is then the
/// nonlinear joint's for any small motion, as a margin assumes.
class Drawing {
 public:
  Drawing(std::uint64_t seed, int set) : noise_(seed, "compare filters", "sets"), set_(set) {}

  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * noise_.uniform(64 * Tick{set_} + next_++); }

  Subject draw(const std::vector<Subject>& subjects) {
    Subject subject = subjects[static_cast<std::size_t>(uniform(0.0, static_cast<double>(subjects.size())))];
    subject.joint.actuator.area_b = subject.joint.actuator.area_a;
    robot::Sensors& s = subject.joint.sensors;
    s.position = low_pass(30.0, 450.0);
    s.velocity = low_pass(30.0, 450.0);
    s.force = low_pass(30.0, 450.0);
    s.anti_alias = low_pass(100.0, 450.0);
    subject.joint.equalises_filters = uniform(0.0, 1.0) < 0.5;
    return subject;
  }

 private:
  control::LowPassParams low_pass(double lowest_Hz, double highest_Hz) {
    const double cut_off_Hz = lowest_Hz * std::pow(highest_Hz / lowest_Hz, uniform(0.0, 1.0));
    const int order = uniform(0.0, 1.0) < 0.5 ? 1 : 2;
    const double damping = uniform(0.4, 1.2);
    return uniform(0.0, 1.0) < 0.3 ? control::LowPassParams{} : control::LowPassParams{cut_off_Hz, order, damping};
  }

  NoiseStream noise_;
  int set_;
  int next_ = 0;
};

/// Compares the margins of one drawn set with the loop that runs.
Result<Done> check(const Subject& subject, int delay_ticks, double disk_margin_min, FilterChecks& checks) {
  const auto gains = FARRIER_TRY(design(subject, delay_ticks));
  const control::Margins margins = margins_behind_filters(subject, gains);
  const RunningLoop loop{subject.joint, subject.load, gains, subject.period_s};
  ++checks.sets;
  if (margins.disk == 0.0) {
    ++checks.unstable;
    checks.unstable_agreed += FARRIER_TRY(trials::is_stable(loop, {})) ? 0 : 1;
    return Done{};
  }
  if (margins.disk < disk_margin_min) {
    ++checks.refused;
    return Done{};
  }
  const std::string name = subject.name + ", " + robot::filters_text(subject.joint) + ", delay " +
                           std::to_string(delay_ticks) + (subject.joint.equalises_filters ? ", equalised" : "");
  if (std::isfinite(margins.gain_up)) {
    const double edge = FARRIER_TRY(trials::first_unstable(
        loop, [&](double factor) { return trials::LoopChange{.gain = std::max(1.0, factor * margins.gain_up)}; }));
    checks.margins.push_back({name, "gain_up", margins.gain_up, edge});
  }
  if (margins.gain_down > 0.0) {
    // Less gain is the way to the edge.
    const double edge = FARRIER_TRY(trials::first_unstable(
        loop, [&](double factor) { return trials::LoopChange{.gain = std::min(1.0, margins.gain_down / factor)}; }));
    checks.margins.push_back({name, "gain_down", margins.gain_down, edge});
  }
  if (margins.delay_ticks < trials::kLongestDelay_ticks / 1.1) {
    const double edge = FARRIER_TRY(trials::first_unstable(
        loop, [&](double factor) { return trials::LoopChange{.delay_ticks = factor * margins.delay_ticks}; }));
    checks.margins.push_back({name, "delay", margins.delay_ticks, edge});
  }
  return Done{};
}

Result<FilterChecks> check_all(const std::vector<Subject>& subjects, double disk_margin_min, std::uint64_t seed) {
  FilterChecks checks;
  Progress progress("compare filters, loops that run", kSets);
  for (int set = 0; checks.measured() < kSets; ++set) {
    if (participant::stop_requested()) {
      return Error{"interrupted"};
    }
    Drawing drawing(seed, set);
    const Subject subject = drawing.draw(subjects);
    if (robot::filters_text(subject.joint).empty()) {
      continue;
    }
    FARRIER_TRY(check(subject, static_cast<int>(drawing.uniform(0.0, 3.0)), disk_margin_min, checks));
    progress.update(checks.measured());
  }
  return checks;
}

}  // namespace

int run_filters(const robot::Robot& robot, const CompareOptions& options) {
  participant::install_signal_handlers();
  const auto rig = robot::load_robot(shipped_robot("fc1d.yaml"));
  if (!rig) {
    return fail("compare", config::to_string(rig.error()));
  }
  const std::vector<Subject> subjects = subjects_of(rig.value(), robot);
  const auto rows = table_of(subjects);
  const auto checks = check_all(subjects, robot.update_logic.disk_margin_min, options.seed);
  if (!rows || !checks) {
    return fail("compare", rows ? checks.error().message : rows.error().message);
  }
  report::Outcome outcome;
  outcome.command = "compare";
  outcome.run = report::run_info(robot, options.seed);
  report::add_filters(outcome.figures, checks.value());
  if (auto written = report::write_json(options.json_path, outcome); !written) {
    return fail("compare", written.error().message);
  }
  std::printf("%s\n%s", report::filters_text(checks.value(), rows.value()).c_str(),
              report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str());
  std::printf("figures: %s\n", options.json_path.c_str());
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace farrier::cli
