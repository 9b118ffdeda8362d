#pragma once

#include <string>
#include <vector>

#include "tools/faults/fault_cell.hpp"

namespace farrier::faults {

/// The longest time of a check over the cells of a row, by its words; with its bound.
std::vector<Check> worst_checks(const std::vector<Cell>& cells, const std::string& row);

/// The table of docs/faults.md: each row's fault, the answer of each process, and the event that an operator sees.
std::string faults_table_markdown();

/// docs/results/faults.md: the checks of each row as they were measured in `cells`, and the cells that did not hold. The
/// clock went slower than the machine's by the factor `slow`.
std::string fault_page_markdown(const std::vector<Cell>& cells, std::size_t planned, int slow);

/// Returns in one line why a cell does not hold.
std::string why_not(const Cell& cell);

}  // namespace farrier::faults
