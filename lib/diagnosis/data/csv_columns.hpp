#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/data/recording.hpp"

namespace farrier::diagnosis {

/// Only rows with this text in this column are read.
struct CsvFilter {
  std::string column, value;
};

/// Columns of numbers of a CSV file.
struct CsvColumns {
  std::vector<std::string> header;           ///< every name of the file; empty: no row was read
  std::size_t header_line = 0;
  std::vector<bool> present;                 ///< one per name asked for
  std::vector<std::vector<double>> columns;  ///< likewise; NaN where a cell was refused
  std::vector<std::size_t> line;             ///< of each row
  std::vector<std::string> others;           ///< what the filter's column holds beside its value, the first 64 of them
  std::vector<Finding> findings;
};

/// Reads the columns of these names, a row at a time. Refuses what read_recording says of the file and of its cells,
/// but for missing columns. A row that is refused keeps its place, with NaN in all columns.
CsvColumns read_columns(const std::string& path, const std::vector<std::string>& names,
                        const std::optional<CsvFilter>& filter = std::nullopt);

/// The names of the header line; empty for a file that has none.
std::vector<std::string> read_header(const std::string& path);

}  // namespace farrier::diagnosis
