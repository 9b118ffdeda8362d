#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "participant/participant.hpp"
#include "robot/robot.hpp"

namespace farrier::bench {

/// Ports of whichever member of a bare exchange this is, null where it has none: those that carry samples from tick to
/// tick, without gains, modes and phases.
struct BarePorts {
  /// `names`: the joints that a joint node hosts; none: all. `has_body`: with the samples of a body on a ground.
  static Result<BarePorts> open(const robot::Robot& robot, const std::vector<std::string>& names, bool has_body,
                                participant::Participant& member);

  std::vector<std::uint16_t> joints;
  participant::In<signals::JointSensors>* sensors = nullptr;
  participant::In<signals::JointCommand>* commands = nullptr;
  participant::In<signals::JointValveCommand>* valves = nullptr;
  participant::In<signals::JointMeasurement>* measurements = nullptr;
  participant::In<signals::ClockTick>* clock = nullptr;
  participant::In<signals::BodyImu>* imu = nullptr;
  participant::In<signals::ClockTickDone>* done = nullptr;  ///< lock-step
  participant::Out<signals::JointSensors>* sensors_out = nullptr;
  participant::Out<signals::JointCommand>* commands_out = nullptr;
  participant::Out<signals::JointValveCommand>* valves_out = nullptr;
  participant::Out<signals::JointMeasurement>* measurements_out = nullptr;
  participant::Out<signals::ClockTick>* clock_out = nullptr;
  participant::Out<signals::BodyImu>* imu_out = nullptr;
  participant::Out<signals::BodyTruth>* truth_out = nullptr;
  participant::Out<signals::BodyState>* state_out = nullptr;
};

}  // namespace farrier::bench
