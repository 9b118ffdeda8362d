#include "report/body/supply_result.hpp"

#include <algorithm>
#include <cstdio>

namespace farrier::report {
namespace supply_result {
namespace {

template <class Choice>
void take(std::optional<double>& worst, const std::optional<double>& value, const Choice& choice) {
  if (value) {
    worst = worst ? choice(*worst, *value) : *value;
  }
}

void add_run(const trials::SupplyFigures& run, SupplyTrialResult& result) {
  const auto later = [](double a, double b) { return std::max(a, b); };
  const auto earlier = [](double a, double b) { return std::min(a, b); };
  ++result.runs;
  result.acted += run.acts_s ? 1 : 0;
  result.unnoticed_sags += run.sag_s && !(run.low_s && *run.low_s < *run.sag_s) ? 1 : 0;
  result.not_lying += run.lying_s ? 0 : 1;
  take(result.low_s, run.low_s, later);
  take(result.sag_s, run.sag_s, earlier);
  take(result.acts_s, run.acts_s, earlier);
  take(result.lying_s, run.lying_s, later);
  result.sinking_m_s = std::max(result.sinking_m_s, run.largest_sinking_m_s);
  result.foot_force_N = std::max(result.foot_force_N, run.largest_foot_force_N);
}

std::string after(const char* what, const std::optional<double>& seconds) {
  char text[64];
  if (seconds) {
    std::snprintf(text, sizeof text, "%s after %.2f s", what, *seconds);
  } else {
    std::snprintf(text, sizeof text, "%s never", what);
  }
  return text;
}

}  // namespace
}  // namespace supply_result

std::vector<SupplyTrialResult> supply_results(std::span<const trials::TrotRow> rows) {
  std::vector<SupplyTrialResult> results;
  for (const trials::TrotTrial& trial : trials::kTrotTrials) {
    SupplyTrialResult result;
    result.trial = trial.name;
    for (const trials::TrotRow& row : rows) {
      if (row.trial == trial.name && row.failure.empty() && row.figures.supply) {
        supply_result::add_run(*row.figures.supply, result);
      }
    }
    if (result.runs > 0) {
      results.push_back(result);
    }
  }
  return results;
}

void add_supply(Figures& figures, std::span<const SupplyTrialResult> results) {
  for (const SupplyTrialResult& result : results) {
    const auto add = [&](const char* name, double value, bool none_allowed = false) {
      figures.add("body." + result.trial + "." + name, value, none_allowed ? std::optional(0.0) : std::nullopt);
    };
    const auto add_if = [&](const char* name, const std::optional<double>& value) {
      if (value) {
        add(name, *value);
      }
    };
    add("acted", static_cast<double>(result.acted), result.trial == "supply");
    add("unnoticed_sags", static_cast<double>(result.unnoticed_sags), true);
    add("not_lying", static_cast<double>(result.not_lying), result.trial == "pump_stops");
    add_if("low_s", result.low_s);
    add_if("sag_20mm_s", result.sag_s);
    add_if("acts_s", result.acts_s);
    add_if("lying_s", result.lying_s);
    add("sinking_m_s", result.sinking_m_s);
    add("foot_force_N", result.foot_force_N);
  }
}

std::string supply_text(std::span<const SupplyTrialResult> results) {
  std::string text;
  for (const SupplyTrialResult& result : results) {
    char worst[96];
    std::snprintf(worst, sizeof worst, "sinks by at most %.2f m/s, foot force at most %.0f N", result.sinking_m_s,
                  result.foot_force_N);
    text += result.trial + ": " + supply_result::after("low", result.low_s) + ", " +
            supply_result::after("20 mm of sag", result.sag_s) + ", " +
            supply_result::after("locomotion acts", result.acts_s) + ", " +
            supply_result::after("lies", result.lying_s) + ", " + worst + "\n";
  }
  return text;
}

}  // namespace farrier::report
