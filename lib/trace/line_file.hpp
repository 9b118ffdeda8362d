#pragma once

#include <charconv>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"

namespace farrier::trace {

/// Path of a file beside a trace: "out/trace.csv" and "body" give "out/trace_body.csv".
std::string path_beside(const std::string& trace_path, const std::string& what);

/// A file of lines that is being written.
class LineFile {
 public:
  /// Writes the header. Refuses a path that cannot be written.
  static Result<LineFile> create(const std::string& path, const std::string& header);

  void write_lines(std::string_view lines);

  /// Flushes; false when the disk did not take everything.
  [[nodiscard]] bool finish();

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };
  explicit LineFile(std::FILE* file) : file_(file) {}

  std::unique_ptr<std::FILE, Close> file_;
};

/// Formats a tick and the numbers that `visit` calls its argument with as a line between `line` and `end`, in their
/// shortest exact form; returns the end of the line. It leaves out what has no room.
template <class Visit>
char* format_numbers(std::int64_t tick, char* line, char* end, Visit&& visit) noexcept {
  char* at = std::to_chars(line, end - 2, tick).ptr;
  visit([&](double number) {
    *at++ = ',';
    at = std::to_chars(at, end - 2, number).ptr;
  });
  *at++ = '\n';
  return at;
}

/// Reads rows of a tick and numbers. `visit(row, read)` calls read(number) for every number behind the tick, in column
/// order. Refuses a file with another header and a line with other numbers; `what` is "the trace of a body".
template <class Row, class Tick, class Visit>
Result<std::vector<Row>> read_numbers(const std::string& path, const std::string& header, const std::string& what,
                                      Tick&& tick_of, Visit&& visit) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line != header) {
    return Error{path + ":1: not " + what + " of this version"};
  }
  std::vector<Row> rows;
  for (int number = 2; std::getline(file, line); ++number) {
    Row row;
    const char* at = line.data();
    const char* const end = at + line.size();
    bool good = true;
    const auto read = [&](auto& value) {
      const auto got = std::from_chars(at, end, value);
      good = good && got.ec == std::errc();
      at = got.ptr != end && *got.ptr == ',' ? got.ptr + 1 : got.ptr;
    };
    read(tick_of(row));
    visit(row, read);
    if (!good || at != end) {
      return Error{path + ":" + std::to_string(number) + ": not a line of " + what};
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace farrier::trace
