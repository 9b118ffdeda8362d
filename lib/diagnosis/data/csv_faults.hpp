#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "diagnosis/data/csv_columns.hpp"
#include "diagnosis/data/csv_text.hpp"
#include "diagnosis/judge/finding_text.hpp"

namespace farrier::diagnosis {

/// The finding of a line that is no text.
Finding not_text(std::size_t line);

/// Faults in the cells of one column.
class CellFaults {
 public:
  /// The number of a cell, NaN for a fault, which is kept.
  double read(const std::string& cell, std::size_t line);
  void report(const std::string& name, std::vector<Finding>& findings) const;

 private:
  Places empty_, text_, not_finite_;
  std::string first_text_;
};

/// Rows of another length than the header.
struct RaggedRows {
  Places places = {};
  std::size_t first_cells = 0;
  bool cut_off = false;  ///< the last line alone, and the file ends within it

  void add(std::size_t cells, const CsvLines& lines);
  void report(CsvColumns& table) const;
};

}  // namespace farrier::diagnosis
