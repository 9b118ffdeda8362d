#include "report/body/switches_result.hpp"

#include <algorithm>

#include "core/median.hpp"
#include "report/body/body_result.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

constexpr double kInMilliseconds = 1e3;

void add(const trials::GainSwitches& one, trials::GainSwitches& sum) {
  sum.planned += one.planned;
  sum.felt += one.felt;
  sum.late_touchdowns += one.late_touchdowns;
  sum.late_s += one.late_s;
  sum.largest_late_s = std::max(sum.largest_late_s, one.largest_late_s);
}

SwitchesResult result_of(const std::string& trial, std::span<const trials::TrotRow> rows) {
  SwitchesResult result{.trial = trial};
  std::vector<const trials::TrotFigures*> upright;
  for (const trials::TrotRow& row : rows) {
    if (row.trial == trial && row.failure.empty()) {
      ++result.runs;
      result.falls += row.figures.fell_s ? 1 : 0;
      add(row.figures.switches, result.switches);
      if (!row.figures.fell_s) {
        upright.push_back(&row.figures);
      }
    }
  }
  for_each_force_error([&](std::size_t place, std::size_t phase, const std::string&) {
    std::vector<double> errors;
    std::ranges::transform(upright, std::back_inserter(errors),
                           [&](const auto* figures) { return figures->force_nrmse[place][phase]; });
    result.force_nrmse[place][phase] = median_or_zero(std::move(errors));
  });
  return result;
}

}  // namespace

double SwitchesResult::mean_late_ms() const noexcept {
  return switches.late_touchdowns > 0 ? kInMilliseconds * switches.late_s / switches.late_touchdowns : 0.0;
}

std::vector<SwitchesResult> switches_results(std::span<const trials::TrotRow> rows) {
  std::vector<SwitchesResult> results;
  for (const trials::TrotTrial& trial : trials::kTrotTrials) {
    const SwitchesResult result = result_of(trial.name, rows);
    if (result.switches.planned > 0) {
      results.push_back(result);
    }
  }
  return results;
}

void add_switches(Figures& figures, std::span<const SwitchesResult> results) {
  for (const SwitchesResult& result : results) {
    const std::string prefix = "body." + result.trial + ".";
    figures.add(prefix + "planned_switches", result.switches.planned);
    figures.add(prefix + "felt_switches", result.switches.felt);
    figures.add(prefix + "late_touchdowns", result.switches.late_touchdowns);
    figures.add(prefix + "mean_late_ms", result.mean_late_ms());
    figures.add(prefix + "largest_late_ms", kInMilliseconds * result.switches.largest_late_s);
  }
}

std::string switches_text(std::span<const SwitchesResult> results) {
  if (results.empty()) {
    return "";
  }
  std::vector<std::vector<std::string>> cells{{"gains", "runs", "falls", "planned", "felt", "late touchdowns",
                                               "mean ms", "largest ms", "haa swing", "stance", "hfe swing", "stance",
                                               "kfe swing", "stance"}};
  for (const SwitchesResult& result : results) {
    std::vector<std::string> line{result.trial, std::to_string(result.runs), std::to_string(result.falls)};
    for (const int count : {result.switches.planned, result.switches.felt, result.switches.late_touchdowns}) {
      line.push_back(std::to_string(count));
    }
    line.push_back(short_number(result.mean_late_ms()));
    line.push_back(short_number(kInMilliseconds * result.switches.largest_late_s));
    for_each_force_error([&](std::size_t place, std::size_t phase, const std::string&) {
      line.push_back(result.falls < result.runs ? short_number(result.force_nrmse[place][phase]) : "-");
    });
    cells.push_back(line);
  }
  return aligned(cells);
}

}  // namespace farrier::report
