#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "signals/signals.hpp"

namespace farrier::trace {

/// Path of a trace's second file, which has the body: "out/trace.csv" gives "out/trace_body.csv".
std::string body_trace_path(const std::string& trace_path);

/// Writes the truth of a body as CSV, a line a tick; numbers in their shortest exact form. Holds no wall time: equal
/// runs give equal bytes.
class BodyTraceWriter {
 public:
  static constexpr std::size_t kLongestLine = 1024;

  /// Refuses a path that cannot be written.
  static Result<BodyTraceWriter> create(const std::string& path, int legs);

  void write(const signals::BodyTruth& truth);

  /// Formats the line of write(), at most kLongestLine characters, at `line`; returns its end. One thread may do this
  /// while another is in write_lines().
  char* format(const signals::BodyTruth& truth, char* line) const noexcept;
  void write_lines(std::string_view lines);

  /// Flushes; false when the disk did not take everything.
  [[nodiscard]] bool finish();

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };
  BodyTraceWriter(std::FILE* file, int legs) : file_(file), legs_(legs) {}

  std::unique_ptr<std::FILE, Close> file_;
  int legs_;
};

/// Reads it back. Refuses a file that is not the body's trace of a robot with so many legs, with the line.
Result<std::vector<signals::BodyTruth>> read_body_trace(const std::string& path, int legs);

}  // namespace farrier::trace
