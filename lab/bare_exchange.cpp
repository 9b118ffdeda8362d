#include "lab/bare_exchange.hpp"

#include <algorithm>

namespace farrier::lab {
namespace {

using namespace signals;
using participant::In;
using participant::Out;

std::vector<std::uint16_t> numbers_of(const robot::Robot& robot, const std::vector<std::string>& names) {
  std::vector<std::uint16_t> numbers;
  for (const robot::Joint& joint : robot.joints) {
    if (names.empty() || std::find(names.begin(), names.end(), joint.name) != names.end()) {
      numbers.push_back(joint.number);
    }
  }
  return numbers;
}

/// Counts what arrives on one port. A process may go on when each of its counters has seen all of a tick.
template <class Signal>
class Counted {
 public:
  Counted(In<Signal>* port, std::size_t per_tick) : port_(port), per_tick_(per_tick) {}

  void drain() { count_ += port_ == nullptr ? 0 : drain_new(); }
  bool has(Tick tick) const noexcept {
    return port_ == nullptr || count_ >= per_tick_ * (static_cast<std::size_t>(tick) + 1);
  }

 private:
  std::size_t drain_new() {
    std::size_t count = 0;
    port_->drain([&](const Signal&) { ++count; });
    return count;
  }

  In<Signal>* port_;
  std::size_t per_tick_;
  std::size_t count_ = 0;
};

template <class Signal>
void send_all(Out<Signal>* port, const std::vector<std::uint16_t>& keys, Tick tick) {
  for (const std::uint16_t key : port == nullptr ? std::vector<std::uint16_t>{} : keys) {
    Signal signal;
    participant::key_of(signal) = key;
    signal.tick = tick;
    port->publish(signal);
  }
}

/// Ports of whichever member this is; null where it has none.
struct BarePorts {
  In<JointSensors>* sensors = nullptr;
  In<JointCommand>* commands = nullptr;
  In<JointValveCommand>* valves = nullptr;
  In<JointMeasurement>* measurements = nullptr;
  In<ClockTick>* clock = nullptr;
  In<ClockTickDone>* done = nullptr;
  Out<JointSensors>* sensors_out = nullptr;
  Out<JointCommand>* commands_out = nullptr;
  Out<JointValveCommand>* valves_out = nullptr;
  Out<JointMeasurement>* measurements_out = nullptr;
  Out<ClockTick>* clock_out = nullptr;
};

class BareMember final : public GaitSource {
 public:
  BareMember(BarePorts ports, std::vector<std::uint16_t> joints, participant::Participant& member, Tick ticks)
      : ports_(ports),
        joints_(std::move(joints)),
        member_(member),
        ticks_(ticks),
        sensors_(ports.sensors, joints_.size()),
        commands_(ports.commands, joints_.size()),
        valves_(ports.valves, joints_.size()),
        measurements_(ports.measurements, joints_.size()),
        clock_(ports.clock, 1),
        done_(ports.done, member.identity().participants - 1u) {}

  void poll(SteadyTime now) override;
  bool finished() const override { return tick_ >= ticks_; }
  int missing() const override { return 1; }
  std::string waits_for() const override { return "samples of tick " + std::to_string(tick_); }
  Tick tick() const override { return tick_; }

 private:
  bool leads() const noexcept { return member_.identity().number == participant::kSimBridge; }
  bool complete() const noexcept;
  void send(Tick tick);

  BarePorts ports_;
  std::vector<std::uint16_t> joints_;
  participant::Participant& member_;
  Tick ticks_;
  Tick tick_ = 0;
  bool primed_ = false;
  Counted<JointSensors> sensors_;
  Counted<JointCommand> commands_;
  Counted<JointValveCommand> valves_;
  Counted<JointMeasurement> measurements_;
  Counted<ClockTick> clock_;
  Counted<ClockTickDone> done_;
};

bool BareMember::complete() const noexcept {
  return sensors_.has(tick_) && commands_.has(tick_) && valves_.has(tick_) && measurements_.has(tick_) &&
         clock_.has(tick_) && done_.has(tick_);
}

void BareMember::send(Tick tick) {
  send_all(ports_.sensors_out, joints_, tick);
  send_all(ports_.commands_out, joints_, tick + 1);
  send_all(ports_.valves_out, joints_, tick);
  send_all(ports_.measurements_out, joints_, tick);
  if (ports_.clock_out != nullptr) {
    ports_.clock_out->publish({0, tick});
  }
  if (!leads()) {
    member_.tick_done(tick);
  }
}

void BareMember::poll(SteadyTime now) {
  sensors_.drain();
  commands_.drain();
  valves_.drain();
  measurements_.drain();
  clock_.drain();
  done_.drain();
  if (!member_.started(now) || finished()) {
    return;
  }
  if (!primed_) {
    // The commands of tick 0 and, from the leader, tick 0 itself.
    send_all(ports_.commands_out, joints_, 0);
    if (leads()) {
      send(0);
    }
    primed_ = true;
  }
  while (!finished() && complete()) {
    if (!leads()) {
      send(tick_);
    }
    ++tick_;
    if (leads() && !finished()) {
      send(tick_);
    }
  }
  if (finished()) {
    member_.report_health(tick_, true);
  }
}

Result<std::unique_ptr<GaitSource>> create(const robot::Robot& robot, const std::vector<std::string>& joints,
                                           participant::Participant& member, Tick ticks) {
  const std::vector<std::uint16_t> numbers = numbers_of(robot, joints);
  std::vector<std::string> names;
  for (const std::uint16_t number : numbers) {
    names.push_back(robot.joints[number].name);
  }
  BarePorts ports;
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
      std::vector<std::uint16_t> others;
      for (std::uint16_t number = 1; number < member.identity().participants; ++number) {
        others.push_back(number);
      }
      take(ports.valves, member.subscribe<JointValveCommand>(numbers));
      take(ports.done, member.subscribe<ClockTickDone>(others));
      take(ports.sensors_out, member.publish<JointSensors>(numbers, names));
      take(ports.clock_out, member.publish<ClockTick>({0}));
      break;
    }
    case participant::kEstimatorService:
      take(ports.measurements, member.subscribe<JointMeasurement>(numbers));
      break;
    case participant::kSupervisor: take(ports.clock, member.subscribe<ClockTick>({0})); break;
    case participant::kGaitSource:
      take(ports.clock, member.subscribe<ClockTick>({0}));
      take(ports.commands_out, member.publish<JointCommand>(numbers, names));
      break;
    default:
      take(ports.sensors, member.subscribe<JointSensors>(numbers, names));
      take(ports.commands, member.subscribe<JointCommand>(numbers, names));
      take(ports.valves_out, member.publish<JointValveCommand>(numbers));
      take(ports.measurements_out, member.publish<JointMeasurement>(numbers));
  }
  if (!opened) {
    return opened.error();
  }
  return std::unique_ptr<GaitSource>(std::make_unique<BareMember>(ports, numbers, member, ticks));
}

}  // namespace

Result<std::unique_ptr<participant::Application>> create_bare(const robot::Robot& robot,
                                                              const std::vector<std::string>& joints,
                                                              participant::Participant& participant, Tick ticks) {
  auto member = create(robot, joints, participant, ticks);
  if (!member) {
    return member.error();
  }
  return std::unique_ptr<participant::Application>(std::move(member).value());
}

Result<std::unique_ptr<GaitSource>> create_bare_gait(const robot::Robot& robot, participant::Participant& participant,
                                                     Tick ticks) {
  return create(robot, {}, participant, ticks);
}

}  // namespace farrier::lab
