#include "bench/bare_exchange/bare_ports.hpp"

#include <algorithm>

namespace farrier::bench {

using namespace signals;

Result<BarePorts> BarePorts::open(const robot::Robot& robot, const std::vector<std::string>& names, bool has_body,
                                  participant::Participant& member) {
  BarePorts ports;
  std::vector<std::string> legs;
  for (const robot::Joint& joint : robot.joints) {
    if (names.empty() || std::ranges::find(names, joint.name) != names.end()) {
      ports.joints.push_back(joint.number);
      legs.push_back(robot.plan.legs[static_cast<std::size_t>(joint.leg)].name);
    }
  }
  Result<Done> opened = Done{};
  const auto take = [&](auto*& port, auto made) {
    if (made) {
      port = made.value();
    } else {
      opened = made.error();
    }
  };
  switch (member.identity().number) {
    case participant::kSimBridge: {
      if (member.identity().clock == bus::ClockKind::kLockstep) {
        std::vector<std::uint16_t> others;
        for (std::uint16_t number = 1; number < member.identity().participants; ++number) {
          others.push_back(number);
        }
        take(ports.done, member.subscribe<ClockTickDone>(others));
      }
      take(ports.valves, member.subscribe<JointValveCommand>(ports.joints));
      take(ports.sensors_out, member.publish<JointSensors>(ports.joints, legs));
      take(ports.clock_out, member.publish<ClockTick>({0}));
      if (has_body) {
        take(ports.imu_out, member.publish<BodyImu>({0}));
        take(ports.truth_out, member.publish<BodyTruth>({0}));
      }
      break;
    }
    case participant::kEstimatorService:
      take(ports.measurements, member.subscribe<JointMeasurement>(ports.joints));
      break;
    case participant::kLocomotion:
      take(ports.clock, member.subscribe<ClockTick>({0}));
      take(ports.commands_out, member.publish<JointCommand>(ports.joints, legs));
      if (has_body) {
        take(ports.sensors, member.subscribe<JointSensors>(ports.joints, legs));
        take(ports.imu, member.subscribe<BodyImu>({0}));
        take(ports.state_out, member.publish<BodyState>({0}));
      }
      break;
    default:
      if (member.identity().number < participant::kFirstJointNode) {
        take(ports.clock, member.subscribe<ClockTick>({0}));
        break;
      }
      take(ports.sensors, member.subscribe<JointSensors>(ports.joints, legs));
      take(ports.commands, member.subscribe<JointCommand>(ports.joints, legs));
      take(ports.valves_out, member.publish<JointValveCommand>(ports.joints));
      take(ports.measurements_out, member.publish<JointMeasurement>(ports.joints));
  }
  if (!opened) {
    return opened.error();
  }
  return ports;
}

}  // namespace farrier::bench
