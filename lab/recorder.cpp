#include "lab/recorder.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "robot/keys.hpp"

namespace farrier::lab {
namespace {

constexpr const char* kLinearHeader = "time_s,valve_current_A,position_m,velocity_m_s,force_N,swing\n";
constexpr const char* kRotaryHeader = "time_s,valve_current_A,angle_rad,velocity_rad_s,torque_Nm,swing\n";

/// Ticks by which a leg may land before its gains change to stance; lift-offs come as planned.
std::size_t unsure_ticks(const robot::Robot& robot) {
  const double unsure_s = robot.plan.gait.touchdown_jitter_s - robot.safety.stance_lead_s;
  return static_cast<std::size_t>(std::ceil(std::max(0.0, unsure_s) / robot.period_s - 1e-6));
}

}  // namespace

JointRecording::JointRecording(const std::string& path, const robot::Robot& robot, const robot::Joint& joint)
    : path_(path),
      joint_(joint.name),
      file_(path, std::ios::binary),
      period_s_(robot.period_s),
      unsure_ticks_(unsure_ticks(robot)),
      currents_A_(static_cast<std::size_t>(robot.loop_delay_lockstep), 0.0) {
  file_ << (joint.rotary ? kRotaryHeader : kLinearHeader);
}

Result<JointRecording> JointRecording::create(const std::string& path, const robot::Robot& robot,
                                              const robot::Joint& joint) {
  errno = 0;
  JointRecording recording(path, robot, joint);
  if (!recording.file_) {
    return Error{"cannot write " + path + ": " + std::strerror(errno)};
  }
  return recording;
}

bool JointRecording::follows(const char* topic, Tick tick, Tick& next) {
  if (!fault_.empty()) {
    return false;
  }
  if (tick != next) {
    fault_ = "the recording of " + joint_ + " lacks " + topic + " of tick " + std::to_string(next) + ": that of tick " +
             std::to_string(tick) + " came; the file ends before it";
    return false;
  }
  ++next;
  return true;
}

void JointRecording::take(const signals::JointSensors& sensors) {
  if (follows("joint/sensors", sensors.tick, next_sensors_)) {
    sensors_.push_back(sensors);
    assemble();
  }
}

void JointRecording::take(const signals::JointValveCommand& valve) {
  if (follows("joint/valve_command", valve.tick, next_valve_)) {
    valves_.push_back(valve);
    assemble();
  }
}

void JointRecording::assemble() {
  while (!sensors_.empty() && !valves_.empty()) {
    const signals::JointSensors& sensors = sensors_.front();
    const signals::JointValveCommand& valve = valves_.front();
    currents_A_.push_back(valve.valve_current_A);
    const bool swing = valve.phase == static_cast<std::uint8_t>(signals::Phase::kSwing);
    if (!swing) {
      for (Row& row : held_) {
        row.swing = false;
      }
    }
    held_.push_back({sensors.tick, currents_A_.front(), sensors.position_m_or_rad, sensors.velocity_m_s_or_rad_s,
                     sensors.force_N_or_Nm, swing});
    currents_A_.pop_front();
    sensors_.pop_front();
    valves_.pop_front();
    ++ticks_;
    if (held_.size() > unsure_ticks_) {
      write(held_.front());
      held_.pop_front();
    }
  }
}

void JointRecording::write(const Row& row) {
  std::array<char, 32> text;  // holds the shortest form of any double
  for (const double value :
       {static_cast<double>(row.tick) * period_s_, row.valve_current_A, row.position, row.velocity, row.force}) {
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    file_.write(text.data(), end - text.data()).put(',');
  }
  file_.put(row.swing ? '1' : '0').put('\n');
}

Result<Done> JointRecording::finish(Tick ticks) {
  for (const Row& row : held_) {
    write(row);
  }
  held_.clear();
  file_.flush();
  if (fault_.empty() && ticks_ < ticks) {
    const bool sensors = next_sensors_ <= next_valve_;
    fault_ = "the recording of " + joint_ + " lacks " + (sensors ? "joint/sensors" : "joint/valve_command") +
             " of tick " + std::to_string(sensors ? next_sensors_ : next_valve_) + ": it did not come";
  }
  if (!fault_.empty()) {
    return Error{fault_};
  }
  if (!file_) {
    return Error{"the recording " + path_ + " is incomplete: disk full?"};
  }
  return Done{};
}

std::string Recorder::path_of(const std::string& directory, const std::string& joint) {
  return (std::filesystem::path(directory) / (joint + ".csv")).string();
}

Result<Recorder> Recorder::create(const robot::Robot& robot, participant::Participant& participant,
                                  const std::string& directory) {
  std::error_code refused;
  std::filesystem::create_directories(directory, refused);
  if (refused) {
    return Error{"cannot write recordings to " + directory + ": " + refused.message()};
  }
  Recorder recorder;
  for (const robot::Joint& joint : robot.joints) {
    auto recording = JointRecording::create(path_of(directory, joint.name), robot, joint);
    if (!recording) {
      return recording.error();
    }
    recorder.joints_.push_back(std::move(recording).value());
  }
  const auto sensors =
      participant.subscribe<signals::JointSensors>(robot::joint_numbers(robot), robot::legs_of_joints(robot));
  if (!sensors) {
    return sensors.error();
  }
  const auto valves = participant.subscribe<signals::JointValveCommand>(robot::joint_numbers(robot));
  if (!valves) {
    return valves.error();
  }
  recorder.sensors_ = sensors.value();
  recorder.valves_ = valves.value();
  return recorder;
}

void Recorder::poll() {
  const auto take = [this](const auto& sample) {
    if (sample.joint < joints_.size()) {
      joints_[sample.joint].take(sample);
    }
  };
  sensors_->drain(take);
  valves_->drain(take);
}

bool Recorder::has(Tick ticks) const noexcept {
  return std::ranges::all_of(joints_, [ticks](const JointRecording& joint) { return joint.ticks() >= ticks; });
}

Result<Done> Recorder::finish(Tick ticks) {
  for (JointRecording& joint : joints_) {
    if (auto finished = joint.finish(ticks); !finished) {
      return finished;
    }
  }
  return Done{};
}

}  // namespace farrier::lab
