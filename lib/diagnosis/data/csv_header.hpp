#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "diagnosis/data/column_names.hpp"
#include "diagnosis/data/csv_columns.hpp"

namespace farrier::diagnosis {

/// The header of a CSV file.
struct CsvHeader {
  std::size_t line = 0;  ///< 0: there is none
  char separator = ',';
  std::vector<std::string> cells = {};
  HeaderMeaning meaning = {};
  std::vector<Finding> findings = {};  ///< not empty: the file cannot be read
  std::vector<std::string> remarks = {};

  /// Place of the column that is read as this one; the number of cells for none.
  std::size_t place_of(const std::string& name) const;
};

/// Finds and understands the header, see read_columns.
CsvHeader read_csv_header(const std::string& path, const std::vector<std::string>& names, const CsvNaming& naming);

/// True for cells that are units, a row under the header; they are taken into its names.
bool take_units(CsvHeader& header, const std::vector<std::string>& cells, const std::vector<std::string>& names,
                const CsvNaming& naming);

}  // namespace farrier::diagnosis
