#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"
#include "tools/faults/fault_cell.hpp"

namespace farrier::faults {

// Cells that held, a line of JSON each, so that an interrupted trial of hours continues.

/// Conditions of the cells; cells of other conditions are not taken over.
struct CellsOrigin {
  std::string git_revision;
  std::string configuration_hash;
  int slow = 1;
  std::string world = "bench";  ///< or "body"
};

/// Appends a cell, on a line of its own also behind one that was cut off. Refuses a file that cannot be written.
Result<Done> append_cell(const std::string& path, const CellsOrigin& origin, const Cell& cell);

/// Cells of this origin; none where there is no file. Passes over a line that was cut off.
std::vector<Cell> read_cells(const std::string& path, const CellsOrigin& origin);

}  // namespace farrier::faults
