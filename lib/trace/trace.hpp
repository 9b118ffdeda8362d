#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "core/time.hpp"
#include "signals/words.hpp"
#include "trace/line_file.hpp"

namespace farrier::trace {

/// One joint at one tick, as the simulated world knows it. Holds no wall time: equal runs give equal bytes.
struct TraceRow {
  Tick tick = kNoTick;
  std::uint16_t joint = 0;
  double position_m_or_rad = 0;  ///< true, not measured
  double velocity_m_s_or_rad_s = 0;
  double force_N_or_Nm = 0;  ///< load cell, true
  double pressure_a_Pa = 0;
  double pressure_b_Pa = 0;
  double force_reference_N_or_Nm = 0;  ///< of the newest valve command that answers this tick or one before
  double valve_current_A = 0;          ///< acts from this tick on
  double external_force_N_or_Nm = 0;
  double load_mass_kg_or_kgm2 = 0;
  Phase phase = Phase::kSwing;         ///< phase whose gains act
  Phase actual_phase = Phase::kSwing;  ///< phase of the simulated leg
  signals::JointState state{};
  std::uint32_t generation = 0;
  std::uint32_t faults = 0;
  std::uint32_t command_age_ticks = 0;  ///< this tick less the tick the valve command answers
};

/// Writes a trace as CSV with a header line; numbers in their shortest exact form (C++17 to_chars).
class TraceWriter {
 public:
  static constexpr std::size_t kLongestLine = 512;

  /// Refuses a path that cannot be written.
  static Result<TraceWriter> create(const std::string& path, std::vector<std::string> joint_names);

  void write(const TraceRow& row);

  /// Formats the line of write(), at most kLongestLine characters, at `line`; returns its end. One thread may do this
  /// while another is in write_lines().
  char* format(const TraceRow& row, char* line) const noexcept;
  void write_lines(std::string_view lines) { file_.write_lines(lines); }

  /// Flushes; false when the disk did not take everything.
  [[nodiscard]] bool finish() { return file_.finish(); }

 private:
  TraceWriter(LineFile file, std::vector<std::string> names) : file_(std::move(file)), joint_names_(std::move(names)) {}

  LineFile file_;
  std::vector<std::string> joint_names_;
};

/// Reads a trace back. Joint numbers are positions in `joint_names`. Refuses a file that is not a trace, with the line.
Result<std::vector<TraceRow>> read_trace(const std::string& path, const std::vector<std::string>& joint_names);

}  // namespace farrier::trace
