#include "report/body/estimators.hpp"

#include <cmath>

#include "report/body/body_result.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

constexpr double kWhole_percent = 100.0;
constexpr double kInMillimetres = 1000.0;

double share(int part, int whole) { return whole > 0 ? static_cast<double>(part) / whole : 0.0; }

std::string percent_text(int part, int whole) { return short_number(std::round(kWhole_percent * share(part, whole))); }

/// The flags of at least one estimate in a hundred, with their share in percent.
std::string flags_text(const trials::EstimateScore& score) {
  std::string text;
  for (std::size_t flag = 0; flag < score.flags.size(); ++flag) {
    if (kWhole_percent * share(score.flags[flag], score.estimates) >= 1.0) {
      text += (text.empty() ? "" : ", ") + std::string(estimation::kEstimateFlags[flag].name) + " " +
              percent_text(score.flags[flag], score.estimates);
    }
  }
  return text.empty() ? "none" : text;
}

std::string estimator_name(const trials::AdaptingResult& result) {
  return result.estimator.empty() ? "fixed" : result.estimator;
}

double kfe_stance_nrmse(const trials::ComparedRuns& runs) {
  constexpr std::size_t kKfe = 2;
  return runs.force_nrmse[kKfe][static_cast<std::size_t>(Phase::kStance)];
}

}  // namespace

void add_estimators(Figures& figures, const std::string& group, std::span<const trials::EstimatorResult> results) {
  for (const trials::EstimatorResult& result : results) {
    if (!result.refusal.empty()) {
      continue;
    }
    for_each_force_error([&](std::size_t place, std::size_t phase, const std::string& name) {
      const trials::EstimateScore& score = result.scores[place][phase];
      const std::string prefix = "compare.body." + group + "." + result.name + "." + name + ".";
      figures.add(prefix + "valid_share", share(score.valid, score.estimates));
      figures.add(prefix + "usable_share", share(score.usable, score.estimates));
      if (score.usable > 0) {
        figures.add(prefix + "valve_ratio", score.valve_ratio);
        figures.add(prefix + "oil_ratio", score.oil_ratio);
        figures.add(prefix + "load_ratio", score.load_ratio);
        figures.add(prefix + "misfit", score.misfit);
        figures.add(prefix + "force_error", score.force_error);
      }
    });
  }
}

std::string estimators_text(std::span<const trials::EstimatorResult> results) {
  std::vector<std::vector<std::string>> cells{
      {"estimator", "joints", "valid %", "usable %", "valve", "oil", "load", "misfit", "force error", "flags, %"}};
  for (const trials::EstimatorResult& result : results) {
    if (!result.refusal.empty()) {
      cells.push_back({result.name, "-", "-", "-", "-", "-", "-", "-", "-", "refused: " + result.refusal});
      continue;
    }
    for_each_force_error([&](std::size_t place, std::size_t phase, const std::string& name) {
      const trials::EstimateScore& score = result.scores[place][phase];
      std::vector<std::string> line{result.name, name, percent_text(score.valid, score.estimates),
                                    percent_text(score.usable, score.estimates)};
      for (const double value :
           {score.valve_ratio, score.oil_ratio, score.load_ratio, score.misfit, score.force_error}) {
        line.push_back(score.usable > 0 ? short_number(value) : "-");
      }
      line.push_back(flags_text(score));
      cells.push_back(line);
    });
  }
  return aligned(cells);
}

void add_adapting(Figures& figures, std::span<const trials::AdaptingResult> results) {
  for (const trials::AdaptingResult& result : results) {
    const std::string prefix = "compare.body.adapting." + result.controller + "." + estimator_name(result) + ".";
    figures.add(prefix + "walk_falls", result.runs.walk_falls);
    figures.add(prefix + "step_falls", result.runs.step_falls);
    if (!result.estimator.empty()) {
      figures.add(prefix + "updates", result.runs.adaptation.updates);
      figures.add(prefix + "refused", result.runs.adaptation.refused + result.runs.adaptation.gains_refused);
      figures.add(prefix + "invalid_updates", result.runs.adaptation.invalid_updates, 0.0);
    }
    if (result.runs.height_rms_m > 0.0) {
      figures.add(prefix + "height_rms_mm", kInMillimetres * result.runs.height_rms_m);
      figures.add(prefix + "kfe_stance_nrmse", kfe_stance_nrmse(result.runs));
    }
  }
}

std::string adapting_text(std::span<const trials::AdaptingResult> results) {
  std::vector<std::vector<std::string>> cells{{"controller", "estimator", "walks fell", "steps fell", "height mm",
                                               "kfe stance", "estimates", "valid %", "updates", "designs refused",
                                               "joint refused", "invalid updates", "why not"}};
  for (const trials::AdaptingResult& result : results) {
    const bool walked = result.runs.height_rms_m > 0.0;
    std::vector<std::string> line{result.controller,
                                  estimator_name(result),
                                  std::to_string(result.runs.walk_falls) + " of " + std::to_string(result.runs.walks),
                                  std::to_string(result.runs.step_falls) + " of " + std::to_string(result.runs.steps),
                                  walked ? short_number(kInMillimetres * result.runs.height_rms_m) : "-",
                                  walked ? short_number(kfe_stance_nrmse(result.runs)) : "-"};
    const trials::AdaptationCounts& counts = result.runs.adaptation;
    if (result.estimator.empty()) {
      line.insert(line.end(), 6, "-");
    } else {
      line.push_back(std::to_string(counts.estimates));
      line.push_back(percent_text(counts.valid, counts.estimates));
      for (const int count : {counts.updates, counts.refused, counts.gains_refused, counts.invalid_updates}) {
        line.push_back(std::to_string(count));
      }
    }
    line.push_back(result.runs.refusal);
    cells.push_back(line);
  }
  return aligned(cells);
}

}  // namespace farrier::report
