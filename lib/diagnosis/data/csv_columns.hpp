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

/// Rules by which the header of a file is understood.
struct CsvNaming {
  bool meanings = false;  ///< names with units and the like are taken as meaning_of() has it; else exact names alone
  std::string joint =
      {};  ///< the joint whose columns are read, and whose rows where a column "joint" names it; may be empty
};

/// Columns of numbers of a CSV file.
struct CsvColumns {
  std::vector<std::string> header;  ///< every name of the file; empty: no row was read
  std::vector<bool> read;           ///< one per name of the file: its column is one that was asked for
  std::size_t header_line = 0;
  std::vector<bool> present;                 ///< one per name asked for
  std::vector<std::vector<double>> columns;  ///< likewise; NaN where a cell was refused
  std::vector<std::size_t> line;             ///< of each row
  std::vector<std::string> others;           ///< what the filter's column holds beside its value, the first 64 of them
  std::vector<Finding> findings;
  std::vector<std::string> remarks;  ///< sentences on what was done to the file's form
};

/// Reads the columns of these names, a row at a time. Refuses what read_recording says of the file and of its cells,
/// but for missing columns. A row that is refused keeps its place, with NaN in all columns.
///
/// The header is the first of the lines up to kMostPreamble that names one of the columns; lines before it are passed over
/// with a remark. Columns are separated by ",", ";" or tabs. Rows may end with a separator. A row of units may follow the
/// header.
CsvColumns read_columns(const std::string& path, const std::vector<std::string>& names,
                        const std::optional<CsvFilter>& filter = std::nullopt, const CsvNaming& naming = {});

/// Lines that are searched for a header.
inline constexpr std::size_t kMostPreamble = 50;

/// The names of the header line; empty for a file that has none.
std::vector<std::string> read_header(const std::string& path);

}  // namespace farrier::diagnosis
