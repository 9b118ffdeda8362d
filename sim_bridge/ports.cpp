#include "sim_bridge/ports.hpp"

#include "robot/keys.hpp"

namespace farrier::sim_bridge {

Result<Ports> Ports::open(participant::Participant& participant, const robot::Robot& robot) {
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

Result<Parts> Parts::assemble(const robot::Robot& robot, std::uint64_t seed, const std::string& trace_path,
                              participant::Participant& participant,
                              std::vector<robot::LoadChange> load_changes) {
  auto world = FARRIER_TRY(SimWorld::create(robot, seed, std::move(load_changes)));
  std::optional<trace::TraceWriter> trace;
  if (!trace_path.empty()) {
    auto writer = FARRIER_TRY(trace::TraceWriter::create(trace_path, robot::joint_names(robot)));
    trace = std::move(writer);
  }
  auto ports = FARRIER_TRY(Ports::open(participant, robot));
  return Parts{std::move(world), std::move(trace), ports};
}

}  // namespace farrier::sim_bridge
