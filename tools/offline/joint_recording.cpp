#include "tools/offline/joint_recording.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/text.hpp"
#include "diagnosis/data/trace_recording.hpp"
#include "robot/keys.hpp"

namespace farrier::offline {
namespace {

using diagnosis::Recording;
using diagnosis::RecordingProblems;
using signals::JointMeasurement;

/// Ticks by which a leg may land before its gains change to stance; lift-offs come as planned.
std::size_t unsure_ticks(const robot::Robot& robot) {
  const double unsure_s = robot.plan.gait.touchdown_jitter_s - robot.safety.stance_lead_s;
  return static_cast<std::size_t>(std::ceil(std::max(0.0, unsure_s) / robot.period_s - 1e-6));
}

/// Places of samples, the end excluded.
struct Stretch {
  std::size_t begin = 0, end = 0;
  std::size_t size() const noexcept { return end - begin; }
};

Stretch longest_without_a_hole(const std::vector<JointMeasurement>& samples) {
  Stretch longest, present;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i > 0 && samples[i].tick != samples[i - 1].tick + 1) {
      present.begin = i;
    }
    present.end = i + 1;
    if (present.size() > longest.size()) {
      longest = present;
    }
  }
  return longest;
}

RecordingProblems problem(const char* what, const std::string& text) { return {{{what, 0, text}}}; }

}  // namespace

Recording joint_recording(const playback::Measurements& measured, const robot::Robot& robot,
                          const robot::Joint& joint) {
  const std::vector<JointMeasurement>& samples = measured.joints[joint.number];
  Recording recording;
  recording.coordinates = diagnosis::coordinates_of(joint);
  recording.period_s = robot.period_s;
  Stretch stretch = longest_without_a_hole(samples);
  const auto delay = static_cast<std::size_t>(measured.loop_delay_ticks(robot));
  // A command from before the first sample is known only where there was none.
  const bool from_the_start = stretch.size() > 0 && samples[stretch.begin].tick == 0;
  const std::size_t first = stretch.begin + (from_the_start ? 0 : std::min(delay, stretch.size()));
  const std::size_t unsure = unsure_ticks(robot);
  for (std::size_t i = first; i < stretch.end; ++i) {
    const JointMeasurement& sample = samples[i];
    recording.time_s.push_back(static_cast<double>(sample.tick) * robot.period_s);
    recording.valve_current_A.push_back(i >= stretch.begin + delay ? samples[i - delay].valve_current_A : 0.0);
    recording.position.push_back(sample.position_m_or_rad);
    recording.velocity.push_back(sample.velocity_m_s_or_rad_s);
    recording.force.push_back(sample.force_N_or_Nm);
    const bool swing = sample.phase == signals::Phase::kSwing;
    if (!swing) {
      const std::size_t rows = recording.swing.size();
      std::fill(recording.swing.end() - static_cast<std::ptrdiff_t>(std::min(unsure, rows)), recording.swing.end(), 0);
    }
    recording.swing.push_back(swing ? 1 : 0);
  }
  if (stretch.size() < samples.size()) {
    recording.remarks.push_back("The recording of " + joint.name + " has holes: of " + std::to_string(samples.size()) +
                                " samples the " + std::to_string(stretch.size()) + " from tick " +
                                std::to_string(samples[stretch.begin].tick) + " on, which are in a row, are taken.");
  }
  return recording;
}

Result<Recording, RecordingProblems> read_joint_recording(const std::string& path, const std::string& joint_name,
                                                          KeepOn keep_on) {
  auto run = playback::RecordedRun::open(path, {}, std::move(keep_on));
  if (!run) {
    return problem("unreadable", run.error().message);
  }
  const robot::Robot& robot = run.value().robot();
  const robot::Joint* const joint = robot.find(joint_name);
  if (joint == nullptr) {
    return problem("no_such_joint", "the recording is of " + robot.name + ", which has no joint " + joint_name +
                                        "; it has " + join(robot::joint_names(robot), ", ") +
                                        ": give --joint one of them");
  }
  playback::Measurements measured = playback::read_measurements(run.value());
  Recording recording = joint_recording(measured, robot, *joint);
  if (recording.time_s.empty()) {
    return problem("no_such_joint", "the recording has no joint/measurement of " + joint_name + ": " +
                                        (measured.ending.empty() ? "record that topic" : measured.ending));
  }
  const double duration_s = static_cast<double>(recording.time_s.size()) * recording.period_s;
  if (recording.time_s.size() < diagnosis::kFewestSamples || duration_s < diagnosis::kShortestDuration_s) {
    return problem("too_short", "only " + std::to_string(recording.time_s.size()) +
                                    " samples in a row: record at least a second of them");
  }
  recording.source = std::filesystem::path(path).filename().string();
  if (!measured.ending.empty()) {
    recording.remarks.push_back("The recording is not whole: " + measured.ending + ".");
  }
  return recording;
}

}  // namespace farrier::offline
