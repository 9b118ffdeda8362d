#pragma once

#include <deque>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "participant/participant.hpp"
#include "robot/robot.hpp"

namespace farrier::lab {

/// What one joint measured and was told, as the CSV file that diagnosis::read_recording reads: row k has the sensors of
/// tick k, the valve current that acts from k to k + 1, and swing 1 where the leg is in the air for certain. Lock-step.
class JointRecording {
 public:
  /// Refuses a file that cannot be written.
  static Result<JointRecording> create(const std::string& path, const robot::Robot& robot, const robot::Joint& joint);

  /// Each takes the ticks 0, 1, ... of this joint in their order; what comes after one that is missing is not written.
  void take(const signals::JointSensors& sensors);
  void take(const signals::JointValveCommand& valve);

  /// Ticks of which both have come, none missing before them.
  Tick ticks() const noexcept { return ticks_; }

  /// Writes what is held back. Refuses with the first sample that is missing before tick `ticks`, and a full disk.
  Result<Done> finish(Tick ticks);

 private:
  struct Row {
    Tick tick;
    double valve_current_A, position, velocity, force;
    bool swing;
  };

  JointRecording(const std::string& path, const robot::Robot& robot, const robot::Joint& joint);
  bool follows(const char* topic, Tick tick, Tick& next);
  void assemble();
  void write(const Row& row);

  std::string path_, joint_;
  std::ofstream file_;
  double period_s_;
  std::size_t unsure_ticks_;                       ///< before gains change to stance in which the leg may have landed
  Tick next_sensors_ = 0, next_valve_ = 0, ticks_ = 0;
  std::deque<signals::JointSensors> sensors_;      ///< that wait for their valve command
  std::deque<signals::JointValveCommand> valves_;  ///< and the other way round
  std::deque<double> currents_A_;                  ///< that wait to act, the first from the tick that is next
  std::deque<Row> held_;                           ///< the last rows, which may turn out not to be swing
  std::string fault_;
};

/// Listens to joint/sensors and joint/valve_command of every joint and writes a JointRecording of each: what crossed
/// the bus, not the simulation's truth. Lock-step only.
class Recorder {
 public:
  static std::string path_of(const std::string& directory, const std::string& joint);

  /// Opens ports of `participant`, which outlives it; hence before the greeting, which makes the run begin only when
  /// they hear everybody. Writes to path_of(), in a directory that is made where it is missing.
  static Result<Recorder> create(const robot::Robot& robot, participant::Participant& participant,
                                 const std::string& directory);

  /// Takes what has come: at least once a tick, or samples are overwritten, which finish() says.
  void poll();
  /// Every sample of this many ticks has come.
  bool has(Tick ticks) const noexcept;
  /// Refuses as JointRecording::finish does.
  Result<Done> finish(Tick ticks);

 private:
  Recorder() = default;

  participant::In<signals::JointSensors>* sensors_ = nullptr;
  participant::In<signals::JointValveCommand>* valves_ = nullptr;
  std::vector<JointRecording> joints_;  ///< by number
};

}  // namespace farrier::lab
