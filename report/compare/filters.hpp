#pragma once

// Result of `farrier compare filters`.

#include <span>
#include <string>
#include <vector>

#include "report/figures/figures.hpp"

namespace farrier::report {

/// A margin of one joint behind one set of filters: computed, and found by simulation, as a factor on the computed one.
struct MarginCheck {
  std::string set;     ///< what was drawn, for people
  const char* margin;  ///< "gain_up", "gain_down", "delay"
  double computed;     ///< factor, or ticks
  double factor;       ///< where the simulated loop becomes unstable; 0.9 or 1.1 where beyond
};

/// All sets that were drawn.
struct FilterChecks {
  int sets = 0;
  int unstable = 0;         ///< computed unstable
  int unstable_agreed = 0;  ///< of these, unstable in the simulation too
  int refused = 0;          ///< a smaller disk margin than update_logic.disk_margin_min
  std::vector<MarginCheck> margins;

  /// Sets whose margins were compared.
  int measured() const { return sets - unstable - refused; }
};

/// A joint behind one set of filters.
struct FilterRow {
  std::string joint, filters;
  double disk;            ///< computed disk margin
  double disk_equalised;  ///< with equalise_filters
};

inline constexpr double kMarginErrorAtMost = 0.05;

/// Adds compare.filters.*.
void add_filters(Figures& figures, const FilterChecks& checks);

/// For people: the worst margins, and a line for each row.
std::string filters_text(const FilterChecks& checks, std::span<const FilterRow> rows);

}  // namespace farrier::report
