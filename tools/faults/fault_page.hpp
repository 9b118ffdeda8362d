#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/faults/fault_cell.hpp"

namespace farrier::faults {

/// The longest time of a check over the cells of a row, by its words; with its bound.
std::vector<Check> worst_checks(const std::vector<Cell>& cells, const std::string& row);

/// The largest of each over the bodies in the cells of a row; none if none has one.
std::optional<BodyAfterFault> worst_body(const std::vector<Cell>& cells, const std::string& row);

/// The table of docs/faults.md: each row's fault, the answer of each process, and the event that an operator sees.
std::string faults_table_markdown();

/// Facts of a run of cells for its page.
struct PageFacts {
  std::size_t planned;                                    ///< cells
  int slow;                                               ///< factor by which the clock went slower than the machine's
  std::optional<std::uint64_t> draw_seed = std::nullopt;  ///< of draw_cells(); none: all cells were planned
};

/// docs/results/faults.md: the checks of each row as they were measured in `cells`, and the cells that did not hold.
std::string fault_page_markdown(const std::vector<Cell>& cells, const PageFacts& facts);

/// The part of docs/results/faults.md about a robot on a ground, with falls, speeds and forces beside the checks.
std::string ground_page_markdown(const std::vector<Cell>& cells, const PageFacts& facts, const std::string& robot);

/// Returns in one line why a cell does not hold.
std::string why_not(const Cell& cell);

}  // namespace farrier::faults
