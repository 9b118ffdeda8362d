#include "diagnosis/data/trace_recording.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "config/visitor.hpp"
#include "diagnosis/data/csv_columns.hpp"
#include "diagnosis/judge/finding_text.hpp"
#include "diagnosis/data/sampling.hpp"
#include "signals/signals.hpp"

namespace farrier::diagnosis {
namespace {

/// Columns, in the order of kTraceNames.
enum Column : std::size_t { kTick, kPosition, kVelocity, kForce, kPressureA, kPressureB, kCurrent, kActualPhase };

const std::vector<std::string> kTraceNames = {
    "tick",          "position_m_or_rad", "velocity_m_s_or_rad_s", "force_N_or_Nm",
    "pressure_a_Pa", "pressure_b_Pa",     "valve_current_A",       "actual_phase"};
constexpr const char* kJoint = "joint";
constexpr const char* kRemedy = " is missing; give a trace of this version of farrier";

bool has_column(const std::vector<std::string>& header, const std::string& name) {
  return std::find(header.begin(), header.end(), name) != header.end();
}

void check_trace_names(CsvColumns& csv) {
  const std::string place = "line " + std::to_string(csv.header_line);
  for (std::size_t i = 0; i < kTraceNames.size(); ++i) {
    if (!csv.present[i]) {
      csv.findings.push_back({"missing_column", csv.header_line, place + ", column " + kTraceNames[i] + kRemedy});
    }
  }
  if (!has_column(csv.header, kJoint)) {
    csv.findings.push_back({"missing_column", csv.header_line, place + ", column " + kJoint + kRemedy});
  }
}

void refuse_joint(CsvColumns& csv, const std::string& joint) {
  std::string text = "the file has no rows of joint " + joint;
  for (std::size_t i = 0; i < csv.others.size(); ++i) {
    text += (i == 0 ? "; it has " : ", ") + shown(csv.others[i]);
  }
  csv.findings.push_back({"no_such_joint", 0, text + "; give the robot file of the run, and one of its joints"});
}

}  // namespace

bool is_trace(const std::string& path) {
  const std::vector<std::string> header = read_header(path);
  return has_column(header, kTraceNames[kTick]) && has_column(header, kJoint) &&
         has_column(header, kTraceNames[kPosition]);
}

Coordinates coordinates_of(const robot::Joint& joint) {
  return joint.rotary ? Coordinates::kRotary : Coordinates::kLinear;
}

Result<Recording, RecordingProblems> recording_of_trace(const std::string& path, const robot::Robot& robot,
                                                        const robot::Joint& joint) {
  CsvColumns csv = read_columns(path, kTraceNames, CsvFilter{kJoint, joint.name});
  if (!csv.header.empty()) {
    check_trace_names(csv);
    if (csv.findings.empty() && csv.line.empty()) {
      refuse_joint(csv, joint.name);
    } else if (csv.present[kTick]) {
      for (double& time : csv.columns[kTick]) {
        time *= robot.period_s;
      }
      const std::vector<Finding> times = check_times(csv.columns[kTick], csv.line);
      csv.findings.insert(csv.findings.end(), times.begin(), times.end());
    }
  }
  if (!csv.findings.empty()) {
    sort_by_line(csv.findings);
    return RecordingProblems{std::move(csv.findings)};
  }
  Recording recording;
  recording.source = std::filesystem::path(path).filename().string();
  recording.coordinates = coordinates_of(joint);
  recording.period_s = robot.period_s;
  recording.time_s = std::move(csv.columns[kTick]);
  recording.valve_current_A = std::move(csv.columns[kCurrent]);
  recording.position = std::move(csv.columns[kPosition]);
  recording.velocity = std::move(csv.columns[kVelocity]);
  recording.force = std::move(csv.columns[kForce]);
  if (!joint.electric) {
    recording.pressure_a_Pa = std::move(csv.columns[kPressureA]);
    recording.pressure_b_Pa = std::move(csv.columns[kPressureB]);
  }
  for (const double phase : csv.columns[kActualPhase]) {
    recording.swing.push_back(phase == static_cast<double>(signals::Phase::kSwing) ? 1 : 0);
  }
  recording.line = std::move(csv.line);
  recording.remarks.push_back("A trace of a simulated run: true values of joint " + joint.name + ", without noise.");
  return recording;
}

}  // namespace farrier::diagnosis
