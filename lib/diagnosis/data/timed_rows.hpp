#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "diagnosis/data/even_grid.hpp"

namespace farrier::diagnosis {

/// A column of a file with uneven times.
struct TimedColumn {
  std::vector<double>* values;  ///< one per row, or empty
  Carry carry = Carry::kInterpolated;
  std::string name;  ///< with its unit, for messages
};

/// Places of rows, from 0 on.
using RowNumbers = std::vector<std::size_t>;

/// Rows of a file by their columns, which belong to the caller.
class TimedRows {
 public:
  TimedRows(std::vector<double>& time_s, std::vector<std::size_t>& line, const std::vector<TimedColumn>& columns)
      : time_s_(time_s), line_(line), columns_(columns) {}

  /// Leaves these rows, in this order.
  void keep(const RowNumbers& rows);
  /// True if all columns have the same values in two rows.
  bool same(std::size_t a, std::size_t b) const;

  struct Copy {
    std::vector<double> time_s;
    std::vector<std::size_t> line;
    std::vector<std::vector<double>> values;
  };
  Copy copy() const;
  void restore(const Copy& copy);

 private:
  std::vector<double>& time_s_;
  std::vector<std::size_t>& line_;
  const std::vector<TimedColumn>& columns_;
};

}  // namespace farrier::diagnosis
