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
  if (auto r = take(ports.valves, participant.subscribe<signals::JointValveCommand>(numbers)); !r) {
    return r.error();
  }
  if (auto r = take(ports.sensors, participant.publish<signals::JointSensors>(numbers, legs)); !r) {
    return r.error();
  }
  if (auto r = take(ports.clock, participant.publish<signals::ClockTick>({0})); !r) {
    return r.error();
  }
  if (participant.identity().clock == bus::ClockKind::kRealtime) {
    return ports;
  }
  std::vector<std::uint16_t> others;
  for (std::uint16_t number = 1; number < participant.identity().participants; ++number) {
    others.push_back(number);
  }
  if (auto r = take(ports.done, participant.subscribe<signals::ClockTickDone>(others)); !r) {
    return r.error();
  }
  if (auto r = take(ports.gains, participant.subscribe<signals::JointControllerGains>(numbers, legs)); !r) {
    return r.error();
  }
  if (auto r = take(ports.modes, participant.subscribe<signals::SystemMode>({0})); !r) {
    return r.error();
  }
  return ports;
}

Result<Parts> Parts::assemble(const robot::Robot& robot, std::uint64_t seed, const std::string& trace_path,
                              participant::Participant& participant,
                              std::vector<robot::LoadChange> load_changes) {
  auto world = SimWorld::create(robot, seed, std::move(load_changes));
  if (!world) {
    return world.error();
  }
  std::optional<trace::TraceWriter> trace;
  if (!trace_path.empty()) {
    auto writer = trace::TraceWriter::create(trace_path, robot::joint_names(robot));
    if (!writer) {
      return writer.error();
    }
    trace = std::move(writer).value();
  }
  auto ports = Ports::open(participant, robot);
  if (!ports) {
    return ports.error();
  }
  return Parts{std::move(world).value(), std::move(trace), ports.value()};
}

}  // namespace farrier::sim_bridge
