#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "gait/schedule.hpp"
#include "tools/faults/fault_cell.hpp"

namespace farrier::faults {

/// A cell of the table of faults that is to be run.
struct CellPlan {
  const Row* row;
  gait::Phase phase;
  std::string vendor;  ///< a name of what the processes of a run speak
  std::uint64_t seed;

  Cell cell() const;  ///< without what was seen
};

/// Row, phase, vendor and seed of a cell, which no two cells of a run have in common.
std::string place_text(const Cell& cell);

/// The rows with these names that are rows of such robots; all of these without names. Refuses a name that is none, with
/// those there are.
Result<std::vector<const Row*>> chosen_rows(const std::vector<std::string>& names, Where robot);

/// Cells of `rows`, the first seed's of all of them before the second's.
std::vector<CellPlan> plan_cells(const std::vector<const Row*>& rows, const std::vector<std::string>& vendors,
                                 int seeds);

/// Draws `count` of `plans` by chance, all of them if there are no more. Each row comes once before a row comes twice, so
/// that the first cells show every row. The first cells of a larger draw are those of a smaller one.
std::vector<CellPlan> draw_cells(const std::vector<CellPlan>& plans, std::size_t count, std::uint64_t seed);

}  // namespace farrier::faults
