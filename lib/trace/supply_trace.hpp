#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "signals/signals.hpp"
#include "trace/line_file.hpp"

namespace farrier::trace {

/// The shared supply at one of its samples, and the account of its pump's work.
struct SupplyRow {
  signals::SupplyState state;
  signals::SupplyTruth truth;
};

/// Path of the file beside a trace that has the supply: "out/trace.csv" gives "out/trace_supply.csv".
std::string supply_trace_path(const std::string& trace_path);

/// Writes the supply as CSV, a line a sample; numbers in their shortest exact form. Pressures in the chambers of
/// actuators are in the trace of the joints. Holds no wall time: equal runs give equal bytes.
class SupplyTraceWriter {
 public:
  static constexpr std::size_t kLongestLine = 512;

  /// Refuses a path that cannot be written.
  static Result<SupplyTraceWriter> create(const std::string& path);

  void write(const SupplyRow& row);

  /// Formats the line of write(), at most kLongestLine characters, at `line`; returns its end. One thread may do this
  /// while another is in write_lines().
  char* format(const SupplyRow& row, char* line) const noexcept;
  void write_lines(std::string_view lines) { file_.write_lines(lines); }

  /// Flushes; false when the disk did not take everything.
  [[nodiscard]] bool finish() { return file_.finish(); }

 private:
  explicit SupplyTraceWriter(LineFile file) : file_(std::move(file)) {}

  LineFile file_;
};

/// Reads it back, without pressures in chambers and the energies of supply/state. Refuses a file that is not the trace
/// of a supply, with the line.
Result<std::vector<SupplyRow>> read_supply_trace(const std::string& path);

}  // namespace farrier::trace
