#include "sim_bridge/ports.hpp"

#include "robot/keys.hpp"

namespace farrier::sim_bridge {

Result<Ports> Ports::open(participant::Participant& participant, const robot::Robot& robot,
                          const SimulatedRobot& world) {
  const auto numbers = robot::joint_numbers(robot);
  const auto legs = robot::legs_of_joints(robot);
  Ports ports{};
  const auto take = [](auto*& port, auto made) -> Result<Done> {
    if (!made) {
      return made.error();
    }
    port = made.value();
    return Done{};
  };
  FARRIER_TRY(take(ports.valves, participant.subscribe<signals::JointValveCommand>(numbers)));
  FARRIER_TRY(take(ports.sensors, participant.publish<signals::JointSensors>(numbers, legs)));
  FARRIER_TRY(take(ports.clock, participant.publish<signals::ClockTick>({0})));
  if (world.truth()) {
    FARRIER_TRY(take(ports.imu, participant.publish<signals::BodyImu>({0})));
    FARRIER_TRY(take(ports.truth, participant.publish<signals::BodyTruth>({0})));
  }
  if (world.supply_state() != nullptr) {
    FARRIER_TRY(take(ports.supply, participant.publish<signals::SupplyState>({0})));
    FARRIER_TRY(take(ports.supply_truth, participant.publish<signals::SupplyTruth>({0})));
  }
  if (participant.identity().clock == bus::ClockKind::kRealtime) {
    return ports;
  }
  std::vector<std::uint16_t> others;
  for (std::uint16_t number = 1; number < participant.identity().participants; ++number) {
    others.push_back(number);
  }
  FARRIER_TRY(take(ports.done, participant.subscribe<signals::ClockTickDone>(others)));
  FARRIER_TRY(take(ports.gains, participant.subscribe<signals::JointControllerGains>(numbers, legs)));
  FARRIER_TRY(take(ports.modes, participant.subscribe<signals::SystemMode>({0})));
  return ports;
}

signals::BodyImu imu_sample(const world::World& world, std::int64_t sample_time_ns) noexcept {
  signals::BodyImu sample;
  sample.tick = world.tick();
  sample.sample_time_ns = sample_time_ns;
  if (const auto imu = world.imu()) {
    for (std::size_t axis = 0; axis < sample.angular_velocity_rad_s.size(); ++axis) {
      sample.angular_velocity_rad_s[axis] = imu->rate_rad_s[static_cast<Eigen::Index>(axis)];
      sample.specific_force_m_s2[axis] = imu->specific_force_m_s2[static_cast<Eigen::Index>(axis)];
    }
  }
  return sample;
}

LowAlarm supply_alarm(const robot::Robot& robot) noexcept {
  return robot.supply_guard ? LowAlarm(robot.supply_guard->low_Pa, robot.supply_guard->recovered_Pa)
                            : LowAlarm(0.0, 0.0);
}

void tell_supply(LowAlarm& alarm, const signals::SupplyState& sample, participant::Participant& participant) {
  const bool before = alarm.on();
  if (const bool low = alarm.step(sample.pressure_Pa); low != before) {
    participant.event(low ? participant::EventKind::kSupplyLow : participant::EventKind::kSupplyRecovered, sample.tick,
                      signals::kNoJoint);
  }
}

Result<Parts> Parts::assemble(std::unique_ptr<SimulatedRobot> world, const robot::Robot& robot,
                              const std::string& trace_path, participant::Participant& participant) {
  auto traces = FARRIER_TRY(Traces::create(trace_path, robot, *world));
  const Ports ports = FARRIER_TRY(Ports::open(participant, robot, *world));
  return Parts{std::move(world), std::move(traces), ports};
}

}  // namespace farrier::sim_bridge
