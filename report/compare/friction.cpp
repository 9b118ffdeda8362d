#include "report/compare/friction.hpp"

#include <algorithm>

#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

/// "0.031 0.12": swing, then stance.
std::string cell_of(const FrictionRun& run) {
  if (run.refused()) {
    return "refused";
  }
  const std::string numbers = short_number(run.swing_nrmse) + " " + short_number(run.stance_nrmse);
  return run.diverged() ? "diverged" : run.is_no_torque_source() ? "(" + numbers + ")" : numbers;
}

bool in_one_table(const FrictionRun& a, const FrictionRun& b) { return a.robot == b.robot && a.filters == b.filters; }

std::string table_of(std::span<const FrictionRun> runs) {
  std::vector<std::vector<std::string>> rows{{"controller"}};
  for (const FrictionRun& run : runs) {
    if (run.contender == runs[0].contender) {
      rows[0].push_back(run.friction);
    }
    if (rows.back()[0] != to_string(run.contender)) {
      rows.push_back({to_string(run.contender)});
    }
    rows.back().push_back(cell_of(run));
  }
  return runs[0].robot + ", filters: " + runs[0].filters + "\n" + aligned(rows, "  ");
}

std::string refusals_of(std::span<const FrictionRun> runs) {
  std::vector<std::string> all;
  for (const FrictionRun& run : runs) {
    if (run.refused() && std::ranges::find(all, run.refusal) == all.end()) {
      all.push_back(run.refusal);
    }
  }
  std::string text = all.empty() ? "" : "refused, each reason once:\n";
  for (const std::string& refusal : all) {
    text += "  " + refusal + "\n";
  }
  return text;
}

}  // namespace

void add_friction(Figures& figures, std::span<const FrictionRun> runs) {
  const auto count = [&](auto is) { return static_cast<double>(std::ranges::count_if(runs, is)); };
  figures.add("compare.friction.runs", static_cast<double>(runs.size()));
  figures.add("compare.friction.refused", count([](const FrictionRun& run) { return run.refused(); }));
  figures.add("compare.friction.no_torque_source",
              count([](const FrictionRun& run) { return run.is_no_torque_source(); }));
  figures.add("compare.friction.diverged", count([](const FrictionRun& run) { return run.diverged(); }), 0.0);
  figures.add("compare.friction.diverged_silently",
              count([](const FrictionRun& run) { return run.diverged() && !run.announced; }), 0.0);
}

std::string friction_text(std::span<const FrictionRun> runs) {
  std::string text = "NRMSE in swing and in stance of the worst joint; in brackets: above 1, no torque source\n\n";
  for (auto begin = runs.begin(); begin != runs.end();) {
    const auto end = std::find_if_not(begin, runs.end(), [&](const auto& run) { return in_one_table(run, *begin); });
    text += table_of({begin, end}) + "\n";
    begin = end;
  }
  return text + refusals_of(runs);
}

}  // namespace farrier::report
