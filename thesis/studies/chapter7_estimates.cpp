// Hubacher (2014), Figs 7.9 and C.4: the models behind the gains of the adaptive run through the load cycle, against
// the truth, as the text has it and as Farrier does it. Farrier's estimator washes out content slower than 20 Hz, so its
// models are compared with the truth above that only.

#include <algorithm>
#include <cmath>
#include <complex>

#include "control/model/model_rows.hpp"
#include "core/median.hpp"
#include "control/model/transfer_function.hpp"
#include "estimation/poles.hpp"
#include "thesis/rig/bode.hpp"
#include "thesis/rig/load_cycle_run.hpp"
#include "thesis/studies/registry.hpp"

namespace farrier::thesis {
namespace chapter7_estimates_studies {
namespace {

using signals::JointControllerGains;

/// Gains that acted at any time within the quarter, in their order, each with when it began to, as a share of the
/// quarter.
struct Acting {
  const JointControllerGains* gains;
  double since;
};

std::vector<Acting> acting_in(const CycleRun& run, std::size_t quarter) {
  const Tick begin = run.cycle.begin[quarter - 1];
  const Tick end = run.cycle.begin[quarter];
  std::vector<Acting> acting{{&acting_before(run, begin + 1), 0.0}};
  for (const JointControllerGains& gains : run.gains) {
    if (gains.effective_tick > begin && gains.effective_tick < end) {
      acting.push_back({&gains, static_cast<double>(gains.effective_tick - begin) / static_cast<double>(end - begin)});
    }
  }
  return acting;
}

control::DiscreteModel model_of(const JointControllerGains& gains) {
  return control::model_of_rows(gains.model_a, gains.model_b);
}

/// Median of a number over the second half of a quarter; the number is that of the model behind the gains that act.
template <class Number>
double settled(const CycleRun& run, std::size_t quarter, const Number& number) {
  const Tick end = run.cycle.begin[quarter];
  std::vector<double> values;
  const JointControllerGains* last = nullptr;
  double value = 0.0;
  for (Tick tick = (run.cycle.begin[quarter - 1] + end) / 2; tick <= end; ++tick) {
    const JointControllerGains& acting = acting_before(run, tick);
    if (&acting != last) {
      last = &acting;
      value = number(model_of(acting));
    }
    values.push_back(value);
  }
  return median(std::move(values));
}

/// Distance of the poles behind the gains of a quarter from the true ones.
double pole_error(const CycleRun& run, std::size_t quarter) {
  const auto truth = estimation::poles<3>(truth_of(run, quarter).a);
  return settled(run, quarter, [&](const control::DiscreteModel& model) {
    return estimation::pole_distance<3>(estimation::poles<3>(model.a), truth);
  });
}

double largest_imaginary(const Eigen::Matrix3d& a) {
  double largest = 0.0;
  for (const std::complex<double> z : estimation::poles<3>(a)) {
    largest = std::max(largest, std::abs(z.imag()));
  }
  return largest;
}

constexpr const char* kAccurate =
    "Note the accurate identification of the poles with the exception of the third section, where real poles instead "
    "of complex poles are identified.";

constexpr ClaimSpec kPoleClaims[] = {
    {"7.9.quarter_2", "Fig. 7.9", kAccurate,
     "Distance of the poles behind the acting gains from the true ones, median over the quarter's second half: a tenth "
     "of the unit circle's "
     "radius.",
     "1", Relation::kAtMost, 0.1},
    {"7.9.quarter_4", "Fig. 7.9", kAccurate, "The same, fourth quarter.", "1", Relation::kAtMost, 0.1},
    fails(
        "lambda 0.85 to 0.98, a valve that is probed with 0.25, 1 and 5 % of its current, and first gains by the exact "
        "model. The poles are real in 9 of 80 runs; else their imaginary part is at most 0.57",
        {"7.9.quarter_3_real", "Fig. 7.9", kAccurate,
         "Largest imaginary part of the poles behind the third quarter's last gains: none.", "1", Relation::kAtMost,
         1e-6}),
    {"7.9.quarter_3_wrong", "Fig. 7.9", kAccurate, "As 7.9.quarter_2, third quarter: more than a tenth.", "1",
     Relation::kAtLeast, 0.1}};

/// Poles behind the acting gains by quarter, and the true ones.
Picture poles_picture(const CycleRun& run, const std::string& caption) {
  Picture picture{caption, 4, {}};
  for (std::size_t quarter = 1; quarter <= trials::kQuarters; ++quarter) {
    Series estimated{"", {}, {}, Style::kPoints, 0};
    for (const Acting& acting : acting_in(run, quarter)) {
      for (const std::complex<double> z : estimation::poles<3>(model_of(*acting.gains).a)) {
        estimated.x.push_back(z.real());
        estimated.y.push_back(z.imag());
        estimated.shade.push_back(acting.since);
      }
    }
    Series truth{"", {}, {}, Style::kCrosses, 1};
    for (const std::complex<double> z : estimation::poles<3>(truth_of(run, quarter).a)) {
      truth.x.push_back(z.real());
      truth.y.push_back(z.imag());
    }
    picture.panels.push_back({.title = "quarter " + std::to_string(quarter),
                              .x_label = "Re z",
                              .y_label = "Im z",
                              .unit_circle = true,
                              .series = {std::move(truth), std::move(estimated)}});
  }
  return picture;
}

std::complex<double> pair_of(const Eigen::Matrix3d& a) {
  const auto z = estimation::poles<3>(a);
  return *std::ranges::max_element(z, {}, [](std::complex<double> one) { return one.imag(); });
}

/// As pole_error, of the complex pair alone.
double pair_error(const CycleRun& run, std::size_t quarter) {
  const std::complex<double> truth = pair_of(truth_of(run, quarter).a);
  return settled(run, quarter, [&](const control::DiscreteModel& model) { return std::abs(pair_of(model.a) - truth); });
}

Result<StudyResult> run_poles(const StudyContext& context) {
  const auto run = FARRIER_TRY(run_cycle_as_printed(context, {}, 0.0, 0.5));
  const auto ours = FARRIER_TRY(run_cycle(context, trials::kAdaptiveCase, 0.5, 1.0));
  StudyResult result;
  result.measured = {{"7.9.quarter_2", pole_error(run, 2), ""},
                     {"7.9.quarter_4", pole_error(run, 4), ""},
                     {"7.9.quarter_3_wrong", pole_error(run, 3), ""},
                     {"7.9.quarter_3_real", largest_imaginary(model_of(at_end_of(run, 3)).a),
                      number_as("true one %.3g", largest_imaginary(truth_of(run, 3).a))}};
  constexpr const char* kPair =
      "As Farrier does it: distance of the complex pair behind the acting gains from the true one, median over the "
      "quarter's second half.";
  result.figures = {{"7.9.farrier_quarter_2", pair_error(ours, 2), "1", kPair},
                    {"7.9.farrier_quarter_4", pair_error(ours, 4), "1", kPair}};
  result.pictures = {
      poles_picture(run,
                    "As the text has it: poles of the models the acting gains were designed for, black to "
                    "yellow within the quarter; crosses: the true load"),
      poles_picture(ours, "As Farrier does it")};
  return result;
}

constexpr const char* kLowToMiddle =
    "This approximation, as can be seen, is quite accurate for low to middle frequencies.";

constexpr const char* kQuiteWell = "The linear estimator does quite well ... in identifying the system ...";
constexpr ClaimSpec low(const char* id, const char* section, const char* sentence, const char* claim) {
  return needs(Condition::kProbedValve, {id, section, sentence, claim, "dB", Relation::kAtMost, 3.0});
}

constexpr ClaimSpec kBodeClaims[] = {
    {"C.4.quarter_1_diverges", "Fig. C.4",
     "The system estimates in column one diverge since the multisine force signal does not excite enough high "
     "frequencies of the system.",
     "Largest error of the acting gains' model above 50 Hz, median over the second half of the first quarter.", "dB",
     Relation::kAtLeast, 6.0},
    low("C.4.quarter_3_low", "Fig. C.4", kLowToMiddle, "The same from 2 to 20 Hz, third quarter."),
    low("C.4.quarter_2_low", "7.5", kQuiteWell, "As C.4.quarter_3_low, second quarter."),
    low("C.4.quarter_4_low", "7.5", kQuiteWell, "The same, fourth quarter.")};

Result<StudyResult> run_bode(const StudyContext& context) {
  const auto run = FARRIER_TRY(run_cycle_as_printed(context, {}, 0.0, 0.4));
  const auto probed = FARRIER_TRY(run_cycle_as_printed(context, {.probing_percent = kProbing_percent}, 0.4, 0.7));
  const auto ours = FARRIER_TRY(run_cycle(context, trials::kAdaptiveCase, 0.7, 1.0));
  const std::vector<double> grid = control::logarithmic_grid(0.5, 450.0, 200);
  const auto response_of = [&](const control::DiscreteModel& model) {
    return control::responses<3>({model.a, model.b, Eigen::RowVector3d(0.0, 0.0, 1.0), 0.0, run.cycle.robot.period_s},
                                 grid);
  };
  const auto error_dB = [&](const CycleRun& of, std::size_t quarter, double from_Hz, double to_Hz) {
    const auto truth = response_of(truth_of(of, quarter));
    return settled(of, quarter, [&](const control::DiscreteModel& model) {
      return largest_difference_dB(grid, response_of(model), truth, from_Hz, to_Hz);
    });
  };
  const auto picture_of = [&](const CycleRun& of, const std::string& caption) {
    std::vector<std::vector<Panel>> columns;
    for (std::size_t quarter = 1; quarter <= trials::kQuarters; ++quarter) {
      std::vector<Curve> curves;
      for (const Acting& acting : acting_in(of, quarter)) {
        curves.push_back({"", response_of(model_of(*acting.gains)), 0, acting.since});
      }
      curves.push_back({"", response_of(truth_of(of, quarter)), 1});
      columns.push_back(bode_panels("quarter " + std::to_string(quarter), grid, curves));
    }
    return bode_picture(caption, std::move(columns));
  };
  StudyResult result;
  result.measured = {{"C.4.quarter_1_diverges", error_dB(run, 1, 50.0, 450.0), ""},
                     {"C.4.quarter_3_low", error_dB(run, 3, 2.0, 20.0), "", error_dB(probed, 3, 2.0, 20.0)},
                     {"C.4.quarter_2_low", error_dB(run, 2, 2.0, 20.0), "", error_dB(probed, 2, 2.0, 20.0)},
                     {"C.4.quarter_4_low", error_dB(run, 4, 2.0, 20.0), "", error_dB(probed, 4, 2.0, 20.0)}};
  constexpr const char* kAbove =
      "As Farrier does it: largest error of the acting gains' model from 30 to 100 Hz, median over the second half of "
      "the quarter.";
  result.figures = {{"C.4.farrier_quarter_2", error_dB(ours, 2, 30.0, 100.0), "dB", kAbove},
                    {"C.4.farrier_quarter_4", error_dB(ours, 4, 30.0, 100.0), "dB", kAbove}};
  result.pictures = {
      picture_of(run,
                 "As the text has it, from valve current to force: models behind the acting gains, black to "
                 "yellow within the quarter; blue: the true load"),
      picture_of(ours, "As Farrier does it")};
  return result;
}

constexpr const char* kConditions =
    "The runs of Fig. 7.8. As the text has it: perfect sensors, xi 6, least squares (6.21) with lambda 0.9, valve not "
    "probed, no "
    "guards. As Farrier does it: the noise of fc1d.yaml, xi 14, its own estimator, valve probed, guards.";

constexpr Study kStudies[] = {
    {"7.9", "Poles behind the gains of the adaptive run", kPoleClaims, run_poles, kConditions},
    {"C.4", "Transfer functions behind the gains of the adaptive run", kBodeClaims, run_bode, kConditions}};

}  // namespace
}  // namespace chapter7_estimates_studies

std::span<const Study> chapter7_estimates() { return chapter7_estimates_studies::kStudies; }

}  // namespace farrier::thesis
