#pragma once

#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace farrier::diagnosis {

/// Reads the lines of a file, one at a time. A line of more than 64 KiB ends the reading, so that a file without line
/// ends cannot fill the memory.
class CsvLines {
 public:
  explicit CsvLines(const std::string& path);

  /// Goes to the next line that is neither empty nor a comment ("#", "%" or "//"); false at the end.
  bool next();

  /// The line without its line end and, on the first line, without a UTF-8 byte order mark. Valid until next().
  std::string_view text() const { return text_; }
  std::size_t number() const { return number_; }  ///< 1-based; 0 before the first
  bool too_long() const { return too_long_; }     ///< the line after this one is
  bool cut_off() const { return file_.eof(); }    ///< the file ends within this line

 private:
  bool next_of_any_kind();

  std::ifstream file_;
  std::vector<char> buffer_;
  std::string_view text_;
  std::size_t number_ = 0;
  bool too_long_ = false;
};

/// The cells of a line, at least one, without white space and quotes around them.
void split(std::string_view line, char separator, std::vector<std::string>& cells);

/// The separator that a line of names has most of: ",", ";" or a tab. "," for none of them.
char separator_of(std::string_view line);

/// Content of a cell.
enum class Cell { kNumber, kEmpty, kText, kNotFinite };

/// Reads a decimal number in the notation of C, in any locale; `value` changes unless the cell is empty or text. One comma
/// and no point is a decimal comma, which the cells of a file with other separators may have.
Cell parse_cell(const std::string& cell, double& value);

/// True if a line has no control characters but white space.
bool is_text(std::string_view line);

}  // namespace farrier::diagnosis
