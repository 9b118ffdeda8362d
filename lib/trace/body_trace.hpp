#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "signals/signals.hpp"
#include "trace/line_file.hpp"

namespace farrier::trace {

/// Path of the file beside a trace that has the body: "out/trace.csv" gives "out/trace_body.csv".
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
  void write_lines(std::string_view lines) { file_.write_lines(lines); }

  /// Flushes; false when the disk did not take everything.
  [[nodiscard]] bool finish() { return file_.finish(); }

 private:
  BodyTraceWriter(LineFile file, int legs) : file_(std::move(file)), legs_(legs) {}

  LineFile file_;
  int legs_;
};

/// Reads it back. Refuses a file that is not the body's trace of a robot with so many legs, with the line.
Result<std::vector<signals::BodyTruth>> read_body_trace(const std::string& path, int legs);

}  // namespace farrier::trace
