#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/result.hpp"

namespace farrier::diagnosis {

/// Units of "position" and "force" in a recording: m and N of a cylinder, or rad and Nm of a rotary motor.
enum class Coordinates { kLinear, kRotary };

/// Measured samples of one joint at a uniform period, in actuator coordinates. Positions count from fully retracted
/// ([0, stroke]). Velocities are positive where they extend, forces of the load cell where they push the load towards
/// extension. A current acts from its sample to the next. All vectors are as long as `time_s` or empty; position,
/// velocity and force are never empty. All values are finite.
struct Recording {
  std::string source;  ///< the file's name, for messages
  Coordinates coordinates = Coordinates::kLinear;
  double period_s = 0.0;  ///< in [20e-6, 50e-3]
  std::vector<double> time_s;
  std::vector<double> valve_current_A;                                   ///< empty: not recorded
  std::vector<double> torque_command_Nm;                                 ///< asked of an electric joint; likewise
  std::vector<double> position, velocity, force;                         ///< m, m/s, N or rad, rad/s, Nm
  std::vector<double> pressure_a_Pa, pressure_b_Pa, supply_pressure_Pa;  ///< absolute; empty: not recorded
  std::vector<std::uint8_t> swing;      ///< 1 where the joint carries its swing load; empty: one load throughout
  bool velocity_derived = false;        ///< from the position
  double derived_velocity_noise = 0.0;  ///< standard deviation, m/s or rad/s; 0 where velocity was measured
  double position_error = 0.0, velocity_error = 0.0,
         force_error = 0.0;          ///< RMS, added by making times even; see even_times.hpp
  std::vector<std::string> remarks;  ///< the reader's notes on the file, as sentences for its user
  std::vector<std::size_t> line;     ///< of the file, 1-based, each sample's; empty: not from a file
};

/// One defect of measured data.
struct Finding {
  std::string what;     ///< its kind, a stable snake_case word
  std::size_t row = 0;  ///< 1-based line of the file where it first occurs; 0: the file as a whole
  std::string text;     ///< a sentence that names the place, how often it was found, and the remedy
};

/// All findings, in the order of the file's lines; never empty. With what could be read, as Recording::remarks.
struct RecordingProblems {
  std::vector<Finding> findings;
  std::vector<std::string> remarks = {};
};

/// One line per finding, each with the place in front: "run.csv:12: ...".
std::string to_string(const std::vector<Finding>& findings, const std::string& source);

/// Reads a CSV file with a header: time_s, position_m and force_N (a rotary motor: angle_rad and torque_Nm), and where
/// recorded valve_current_A (torque_command_Nm), velocity_m_s (velocity_rad_s), pressure_a_Pa, pressure_b_Pa, supply_pressure_Pa and swing
/// (0 or 1). Columns in any order, others are ignored with a remark; white space, quotes, CRLF, a UTF-8 byte order
/// mark, empty lines and comments are allowed. Without a velocity it is derived from the position.
///
/// Files of other programs are read with a remark on what was done. Names may have units (column_names.hpp). Lines may
/// stand before the header, and a row of units after it. Columns may be separated by ";" or tabs, with decimal commas, and
/// rows may end with a separator. Times may jitter, repeat and have gaps as make_even() allows. In a file of several
/// joints those of `joint` are read.
///
/// Refuses with every finding, at most one of a kind in a column. Kinds of the file: unreadable, directory, empty,
/// not_text, no_header, not_a_recording, missing_column, duplicate_column, mixed_coordinates, several_joints,
/// no_such_joint, too_long. Kinds of its cells: ragged_row, empty_cell, not_a_number, nan, not_a_flag. Kinds of its times:
/// time_backwards, duplicate_time, gap, jitter (in at most one interval of a hundred), uneven_sampling, wrong_units,
/// too_short. Needs memory for the samples (at most kMostSamples), not for the file.
Result<Recording, RecordingProblems> read_recording(const std::string& path, const std::string& joint = "");

/// Longest recording that is read: more than an hour at 1 kHz.
inline constexpr std::size_t kMostSamples = 5'000'000;

/// Shortest recording that is accepted.
inline constexpr std::size_t kFewestSamples = 500;
inline constexpr double kShortestDuration_s = 1.0;

}  // namespace farrier::diagnosis
