#include "cli/diagnose/diagnose_benchmark_figures.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "diagnosis/confidence/confidence.hpp"
#include "trials/blind/calibration.hpp"
#include "trials/blind/score.hpp"

namespace farrier::cli {
namespace {

/// Bounds of the diagnosis, over the trials that count.
struct Bounds {
  double named = 0.97;
  double first_alone = 0.85;
  double within_tolerance = 0.85;
  double false_alarms = 0.02;
  double outside_admitted = 0.90;
  double outside_unknown = 0.95;
  double median_size_error = 0.10;
  double confidently_wrong = 0.005;
  double median_gain = 3.0;
  double control_gain = 1.3;
  double spiegelhalter_z = 2.0;
  double calibration_excess = 0.03;
  double coverage = 0.93;
  double interval = 0.95;  ///< that intervals say they cover
};

/// Least share of separable sets of so many effects that are all named.
std::optional<double> least_of_sets(std::size_t effects) {
  return effects == 2   ? std::optional(0.9)
         : effects == 3 ? std::optional(0.8)
         : effects == 4 ? std::optional(0.6)
                        : std::nullopt;
}

/// Adds figures of which there is something to count.
class Adder {
 public:
  explicit Adder(report::Figures& figures) : figures_(figures) {}
  void operator()(const std::string& name, double value, std::optional<double> bound = std::nullopt) const {
    if (std::isfinite(value)) {
      figures_.add(name, value, bound);
    }
  }

 private:
  report::Figures& figures_;
};

void add_calibration(const Adder& add, const std::vector<blind::Outcome>& outcomes, const Bounds& bounds,
                     bool electric) {
  const blind::Calibration c = blind::calibration_of(blind::statements_of(outcomes));
  const std::string prefix = "diagnose.benchmark.";
  add(prefix + "statements", static_cast<double>(c.statements));
  add(prefix + "brier", c.brier);
  add(prefix + "spiegelhalter_z", std::abs(c.spiegelhalter_z), bounds.spiegelhalter_z);
  add(prefix + "calibration_error", c.error);
  add(prefix + "calibration_expected", c.expected);
  add(prefix + "calibration_excess", c.error - c.expected, bounds.calibration_excess);
  add(prefix + "most_confidence", c.most, 1.0 - 1.0 / diagnosis::confidence_map(electric).trials);
  const blind::Coverage covered = blind::coverage_of(outcomes);
  add(prefix + "sizes", static_cast<double>(covered.sizes));
  add(prefix + "interval_coverage", covered.share, bounds.coverage);
  add(prefix + "interval_coverage_low", covered.low, bounds.interval);
  add(prefix + "interval_coverage_high", covered.high, bounds.interval);
}

}  // namespace

void add_benchmark_figures(report::Figures& figures, const std::vector<blind::Outcome>& outcomes, bool electric) {
  Bounds bounds;
  bounds.named = electric ? 0.92 : bounds.named;
  const blind::Score s = blind::score(outcomes);
  const Adder add(figures);
  add("diagnose.benchmark.trials", static_cast<double>(s.trials));
  add("diagnose.benchmark.counted", static_cast<double>(s.counted));
  add("diagnose.benchmark.named", s.named, bounds.named);
  add("diagnose.benchmark.first_alone", s.first_alone, bounds.first_alone);
  add("diagnose.benchmark.within_tolerance", s.within_tolerance, bounds.within_tolerance);
  add("diagnose.benchmark.false_alarms", s.false_alarms, bounds.false_alarms);
  add("diagnose.benchmark.outside_admitted", s.outside_admitted, bounds.outside_admitted);
  add("diagnose.benchmark.outside_unknown", s.outside_unknown, bounds.outside_unknown);
  for (const auto& [size, named] : s.sets_named) {
    const std::string sets = "sets_of_" + std::to_string(size);
    const std::string separable = "diagnose.benchmark.separable_" + sets;
    add("diagnose.benchmark." + sets + "_named", named);
    add(separable + "_counted", static_cast<double>(s.separable.at(size)));
    add(separable + "_named", s.separable_named.at(size), least_of_sets(size));
  }
  add("diagnose.benchmark.set_names_wrong", s.set_names_wrong);
  add("diagnose.benchmark.median_size_error", s.median_size_error, bounds.median_size_error);
  add("diagnose.benchmark.median_s", s.median_s);
  add("diagnose.benchmark.confidently_wrong", s.confidently_wrong, bounds.confidently_wrong);
  add_calibration(add, outcomes, bounds, electric);
  add("diagnose.benchmark.median_gain", s.median_gain, bounds.median_gain);
  add("diagnose.benchmark.controlled", static_cast<double>(s.controlled));
  add("diagnose.benchmark.control_gain", s.control_gain, bounds.control_gain);
  for (const auto& [name, mine] : blind::score_by_effect(outcomes)) {
    add("diagnose.benchmark.effect." + name + ".counted", static_cast<double>(mine.counted));
    add("diagnose.benchmark.effect." + name + ".named", mine.named);
    add("diagnose.benchmark.effect." + name + ".first_alone", mine.first_alone);
    add("diagnose.benchmark.effect." + name + ".within_tolerance", mine.within_tolerance);
    add("diagnose.benchmark.effect." + name + ".control_gain", mine.control_gain);
  }
}

void add_healthy_figures(report::Figures& figures, const std::vector<blind::Outcome>& outcomes, std::size_t joints) {
  const blind::Alarms alarms = blind::alarms_of(outcomes, joints);
  const Adder add(figures);
  add("diagnose.healthy.robots", static_cast<double>(alarms.robots));
  add("diagnose.healthy.joints", static_cast<double>(alarms.joints));
  add("diagnose.healthy.alarms", static_cast<double>(alarms.alarms), 0.0);
  add("diagnose.healthy.joint_alarms", static_cast<double>(alarms.joint_alarms));
  add("diagnose.healthy.alarms_high", alarms.rate_high);
  add("diagnose.healthy.median_s", alarms.median_s);
}

}  // namespace farrier::cli
