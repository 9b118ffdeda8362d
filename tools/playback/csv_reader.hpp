#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace farrier::playback {

/// Rows of a CSV file with commas, quotes as RFC 4180 has them, and either end of line.
class CsvReader {
 public:
  explicit CsvReader(const std::string& path) : file_(path, std::ios::binary) {}

  bool opened() const { return file_.is_open(); }
  /// False at the end.
  bool next(std::vector<std::string>& cells);
  /// Line of the last row, from 1 on.
  std::size_t line() const noexcept { return line_; }
  /// Bytes of the file before the next row; past the end, all of them.
  std::uint64_t position();

 private:
  std::ifstream file_;
  std::size_t line_ = 0;
  std::size_t next_line_ = 1;
};

}  // namespace farrier::playback
