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

constexpr double kHardLanding_m_s = 0.5;
constexpr std::size_t kRunsPerHardLanding = 8;  // of which one is allowed

void add_run(const trials::SupplyFigures& run, bool fell, SupplyTrialResult& result) {
  const auto later = [](double a, double b) { return std::max(a, b); };
  const auto earlier = [](double a, double b) { return std::min(a, b); };
  ++result.runs;
  result.slowed += run.slows_s ? 1 : 0;
  result.acted += run.acts_s ? 1 : 0;
  result.unnoticed_sags += run.sag_s && !(run.low_s && *run.low_s < *run.sag_s) ? 1 : 0;
  result.not_lying += run.lying_s ? 0 : 1;
  result.not_recovered += run.recovers ? 0 : 1;
  result.hard_landings += fell || !run.lying_s || !(run.largest_sinking_m_s < kHardLanding_m_s) ? 1 : 0;
  result.end_speed_m_s += (run.end_speed_m_s - result.end_speed_m_s) / static_cast<double>(result.runs);
  take(result.low_s, run.low_s, later);
  take(result.sag_s, run.sag_s, earlier);
  take(result.slows_s, run.slows_s, earlier);
  take(result.acts_s, run.acts_s, earlier);
  take(result.lying_s, run.lying_s, later);
  result.sinking_m_s = std::max(result.sinking_m_s, run.largest_sinking_m_s);
  result.foot_force_N = std::max(result.foot_force_N, run.largest_foot_force_N);
}

// True if the robot shall walk to the end.
bool walks_on(const SupplyTrialResult& result) { return result.trial == "supply" || result.trial == "low_supply"; }

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
        supply_result::add_run(*row.figures.supply, row.figures.fell_s.has_value(), result);
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
    const auto add_at_most = [&](const char* name, double value, std::optional<double> most) {
      figures.add("body." + result.trial + "." + name, value, most);
    };
    const auto add = [&](const char* name, double value, bool none_allowed = false) {
      add_at_most(name, value, none_allowed ? std::optional(0.0) : std::nullopt);
    };
    const auto add_if = [&](const char* name, const std::optional<double>& value) {
      if (value) {
        add(name, *value);
      }
    };
    const bool walks_on = supply_result::walks_on(result);
    const trials::TrotTrial trial = trials::trot_trial(result.trial);
    add("slowed", static_cast<double>(result.slowed), result.trial == "supply");
    add("acted", static_cast<double>(result.acted), walks_on);
    add("unnoticed_sags", static_cast<double>(result.unnoticed_sags), !trial.valve_sticks);
    add("not_recovered", static_cast<double>(result.not_recovered), walks_on);
    add_at_most("hard_landings", static_cast<double>(result.hard_landings),
                trial.lands_softly
                    ? std::optional(static_cast<double>(result.runs / supply_result::kRunsPerHardLanding))
                    : std::nullopt);
    add("not_lying", static_cast<double>(result.not_lying), result.trial == "pump_stops");
    add_if("low_s", result.low_s);
    add_if("sag_20mm_s", result.sag_s);
    add_if("slows_s", result.slows_s);
    add_if("acts_s", result.acts_s);
    add_if("lying_s", result.lying_s);
    add("end_speed_m_s", result.end_speed_m_s);
    add("sinking_m_s", result.sinking_m_s);
    add("foot_force_N", result.foot_force_N);
  }
}

std::string supply_text(std::span<const SupplyTrialResult> results) {
  std::string text;
  for (const SupplyTrialResult& result : results) {
    char worst[96], end[64];
    std::snprintf(worst, sizeof worst, "sinks by at most %.2f m/s, foot force at most %.0f N", result.sinking_m_s,
                  result.foot_force_N);
    if (supply_result::walks_on(result)) {
      std::snprintf(end, sizeof end, "speed at the end %.2f m/s", result.end_speed_m_s);
    } else {
      std::snprintf(end, sizeof end, "hard landings %zu of %zu", result.hard_landings, result.runs);
    }
    text += result.trial + ": " + supply_result::after("low", result.low_s) + ", " +
            supply_result::after("20 mm of sag", result.sag_s) + ", " + supply_result::after("slows", result.slows_s) +
            ", " + supply_result::after("locomotion acts", result.acts_s) + ", " +
            supply_result::after("lies", result.lying_s) + ", " + worst + ", " + end + "\n";
  }
  return text;
}

}  // namespace farrier::report
