#include "diagnosis/data/recording.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <utility>

#include "config/suggest.hpp"
#include "diagnosis/data/column_names.hpp"
#include "diagnosis/data/csv_columns.hpp"
#include "diagnosis/data/derive_velocity.hpp"
#include "diagnosis/data/even_times.hpp"
#include "diagnosis/judge/finding_text.hpp"
#include "diagnosis/data/sampling.hpp"

namespace farrier::diagnosis {
namespace {

/// Columns, in the order of kNames.
enum Column : std::size_t {
  kTime,
  kCurrent,
  kPressureA,
  kPressureB,
  kSupply,
  kSwing,
  kLinearPosition,
  kLinearVelocity,
  kLinearForce,
  kRotaryPosition,
  kRotaryVelocity,
  kRotaryForce,
  kTorqueCommand
};

const std::vector<std::string> kNames = {
    "time_s",         "valve_current_A", "pressure_a_Pa",    "pressure_b_Pa", "supply_pressure_Pa",
    "swing",          "position_m",      "velocity_m_s",     "force_N",       "angle_rad",
    "velocity_rad_s", "torque_Nm",       "torque_command_Nm"};

constexpr std::array kLinear = {kLinearPosition, kLinearVelocity, kLinearForce};
constexpr std::array kRotary = {kRotaryPosition, kRotaryVelocity, kRotaryForce};

/// The columns a recording in these coordinates may have.
std::vector<std::string> names_of(Coordinates coordinates) {
  std::vector<std::string> names(kNames.begin(), kNames.begin() + kLinearPosition);
  for (const Column column : coordinates == Coordinates::kLinear ? kLinear : kRotary) {
    names.push_back(kNames[column]);
  }
  if (coordinates == Coordinates::kRotary) {
    names.push_back(kNames[kTorqueCommand]);
  }
  return names;
}

/// Makes a recording of the columns of one file.
class RecordingReader {
 public:
  RecordingReader(const std::string& path, const std::string& joint)
      : csv_(read_columns(path, kNames, std::nullopt, {.meanings = true, .joint = joint})) {
    recording_.remarks = csv_.remarks;
    recording_.source = std::filesystem::path(path).filename().string();
  }

  Result<Recording, RecordingProblems> read() && {
    if (!csv_.header.empty()) {
      choose_coordinates();
      check_names();
      check_samples();
    }
    if (!csv_.findings.empty()) {
      sort_by_line(csv_.findings);
      return RecordingProblems{std::move(csv_.findings), std::move(recording_.remarks)};
    }
    fill();
    return std::move(recording_);
  }

 private:
  bool has(Column column) const { return csv_.present[column]; }
  const std::array<Column, 3>& motion() const {
    return recording_.coordinates == Coordinates::kLinear ? kLinear : kRotary;
  }
  void refuse(const char* what, const std::string& text) {
    csv_.findings.push_back({what, csv_.header_line, "line " + std::to_string(csv_.header_line) + ", " + text});
  }

  void choose_coordinates() {
    const auto first = [&](const std::array<Column, 3>& columns) {
      const auto found = std::find_if(columns.begin(), columns.end(), [&](Column column) { return has(column); });
      return found == columns.end() ? std::string() : kNames[*found];
    };
    const std::string linear = first(kLinear);
    const std::string rotary = first(kRotary);
    recording_.coordinates = linear.empty() && !rotary.empty() ? Coordinates::kRotary : Coordinates::kLinear;
    if (!linear.empty() && !rotary.empty()) {
      refuse("mixed_coordinates",
             "columns " + linear + " and " + rotary +
                 ": a joint has either position_m, "
                 "velocity_m_s and force_N or angle_rad, velocity_rad_s and torque_Nm; keep those of its actuator");
    }
  }

  void check_names() {
    const std::vector<std::string> known = names_of(recording_.coordinates);
    std::vector<std::pair<std::string, config::Suggestion>> unknown;
    for (std::size_t i = 0; i < csv_.header.size(); ++i) {
      const std::string& name = csv_.header[i];
      if (!csv_.read[i] && std::find(kNames.begin(), kNames.end(), name) == kNames.end()) {
        const auto meant = meant_column(name);
        const bool guessed = meant && meant->group.empty() && std::ranges::find(known, meant->name) != known.end();
        unknown.emplace_back(name, guessed ? config::Suggestion{meant->name, ""} : config::suggest(name, known));
      }
    }
    for (const Column column : {kTime, motion()[0], motion()[2]}) {
      if (!has(column)) {
        const auto near = std::find_if(unknown.begin(), unknown.end(),
                                       [&](const auto& pair) { return pair.second.name == kNames[column]; });
        std::string text = "column " + kNames[column] + " is missing; add it";
        if (near != unknown.end()) {
          text = "column " + kNames[column] + " is missing; " + shown(near->first) +
                 " may be meant: give it that name" +
                 (near->second.unit.empty() ? "" : " and the unit " + near->second.unit);
        }
        refuse("missing_column", text);
      }
    }
    for (const auto& [name, suggestion] : unknown) {
      const auto place = std::find(kNames.begin(), kNames.end(), suggestion.name) - kNames.begin();
      const bool meant = !suggestion.name.empty() && !csv_.present[static_cast<std::size_t>(place)];
      recording_.remarks.push_back((name.empty() ? "A column without a name" : "Column " + shown(name)) +
                                   " is not read" + (meant ? "; did you mean " + suggestion.name + "?" : "."));
    }
  }

  void check_samples() {
    if (has(kSwing)) {
      Places bad;
      for (std::size_t i = 0; i < csv_.line.size(); ++i) {
        const double value = csv_.columns[kSwing][i];
        if (value < 0.0 || value > 1.0 || (value > 0.0 && value < 1.0)) {
          bad.add(csv_.line[i]);
        }
      }
      if (bad.count() > 0) {
        csv_.findings.push_back({"not_a_flag", bad.first(),
                                 bad.text() + ", column swing: " + counted(bad.count(), "value") +
                                     " neither 0 (stance load) nor 1 (swing load)"
                                     "; write one of them"});
      }
    }
    if (has(kTime)) {
      check_sample_times();
    }
  }

  void check_sample_times() {
    if (!csv_.findings.empty()) {
      const std::vector<Finding> times = check_times(csv_.columns[kTime], csv_.line);
      csv_.findings.insert(csv_.findings.end(), times.begin(), times.end());
      return;
    }
    std::vector<TimedColumn> columns;
    for (const Column column :
         {motion()[0], motion()[1], motion()[2], kCurrent, kTorqueCommand, kPressureA, kPressureB, kSupply, kSwing}) {
      columns.push_back({.values = &csv_.columns[column],
                         .carry = column == kCurrent || column == kTorqueCommand ? Carry::kHeld
                                  : column == kSwing                             ? Carry::kFlag
                                                                                 : Carry::kInterpolated,
                         .name = kNames[column]});
    }
    EvenTimes even = make_even(csv_.columns[kTime], csv_.line, columns);
    csv_.findings = std::move(even.findings);
    recording_.remarks.insert(recording_.remarks.end(), even.remarks.begin(), even.remarks.end());
    recording_.position_error = even.added_error[0];
    recording_.velocity_error = even.added_error[1];
    recording_.force_error = even.added_error[2];
  }

  void fill() {
    recording_.period_s = period_of(csv_.columns[kTime]);
    recording_.time_s = std::move(csv_.columns[kTime]);
    recording_.valve_current_A = std::move(csv_.columns[kCurrent]);
    recording_.torque_command_Nm = std::move(csv_.columns[kTorqueCommand]);
    recording_.position = std::move(csv_.columns[motion()[0]]);
    recording_.velocity = std::move(csv_.columns[motion()[1]]);
    recording_.force = std::move(csv_.columns[motion()[2]]);
    recording_.pressure_a_Pa = std::move(csv_.columns[kPressureA]);
    recording_.pressure_b_Pa = std::move(csv_.columns[kPressureB]);
    recording_.supply_pressure_Pa = std::move(csv_.columns[kSupply]);
    recording_.swing.assign(csv_.columns[kSwing].begin(), csv_.columns[kSwing].end());
    recording_.line = std::move(csv_.line);
    if (!has(kCurrent) && !has(kTorqueCommand)) {
      recording_.remarks.push_back("No valve_current_A is recorded: the joint is diagnosed on its load side alone.");
    }
    if (!has(motion()[1])) {
      derive();
    }
  }

  void derive() {
    DerivedVelocity derived = derive_velocity(recording_.position, recording_.period_s);
    const std::string unit = recording_.coordinates == Coordinates::kLinear ? " m/s" : " rad/s";
    recording_.remarks.push_back(
        "No " + kNames[motion()[1]] + " is recorded: it is derived from " + kNames[motion()[0]] + " over windows of " +
        counted(2 * static_cast<std::size_t>(derived.half_window) + 1, "sample") + ", with a noise of " +
        rounded(derived.noise) + unit + " and a bias of " + rounded(derived.bias) + unit + ".");
    recording_.velocity = std::move(derived.velocity);
    recording_.velocity_derived = true;
    recording_.derived_velocity_noise = derived.noise;
  }

  CsvColumns csv_;
  Recording recording_{};
};

}  // namespace

std::string to_string(const std::vector<Finding>& findings, const std::string& source) {
  std::string text;
  for (const Finding& finding : findings) {
    text += source + (finding.row == 0 ? ": " : ":" + std::to_string(finding.row) + ": ") + finding.text + "\n";
  }
  return text;
}

Result<Recording, RecordingProblems> read_recording(const std::string& path, const std::string& joint) {
  return RecordingReader(path, joint).read();
}

}  // namespace farrier::diagnosis
