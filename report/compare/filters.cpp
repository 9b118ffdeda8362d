#include "report/compare/filters.hpp"

#include <algorithm>
#include <cmath>

#include "core/median.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

constexpr const char* kMargins[] = {"gain_up", "gain_down", "delay"};
constexpr std::size_t kWorstShown = 5;

std::vector<double> errors_of(const FilterChecks& checks, std::string_view margin) {
  std::vector<double> errors;
  for (const MarginCheck& check : checks.margins) {
    if (check.margin == margin) {
      errors.push_back(std::abs(check.factor - 1.0));
    }
  }
  return errors;
}

}  // namespace

void add_filters(Figures& figures, const FilterChecks& checks) {
  figures.add("compare.filters.sets", checks.sets);
  figures.add("compare.filters.measured", checks.measured());
  figures.add("compare.filters.refused", checks.refused);
  figures.add("compare.filters.unstable", checks.unstable);
  figures.add("compare.filters.unstable_missed", checks.unstable - checks.unstable_agreed, 0.0);
  for (const char* margin : kMargins) {
    const std::vector<double> errors = errors_of(checks, margin);
    if (!errors.empty()) {
      const std::string prefix = std::string("compare.filters.") + margin + ".";
      figures.add(prefix + "error_median", median(errors));
      figures.add(prefix + "error_worst", std::ranges::max(errors), kMarginErrorAtMost);
    }
  }
}

std::string filters_text(const FilterChecks& checks, std::span<const FilterRow> rows) {
  std::vector<std::vector<std::string>> cells{{"joint", "filters", "disk margin", "equalised"}};
  for (const FilterRow& row : rows) {
    cells.push_back({row.joint, row.filters, short_number(row.disk), short_number(row.disk_equalised)});
  }
  std::string text = aligned(cells) + "\n";
  std::vector<MarginCheck> worst = checks.margins;
  std::ranges::sort(worst, std::greater{}, [](const MarginCheck& check) { return std::abs(check.factor - 1.0); });
  worst.resize(std::min(worst.size(), kWorstShown));
  cells = {{"margins farthest from the simulation's", "margin", "computed", "simulated over computed"}};
  for (const MarginCheck& check : worst) {
    cells.push_back({check.set, check.margin, short_number(check.computed), short_number(check.factor)});
  }
  return text + aligned(cells);
}

}  // namespace farrier::report
