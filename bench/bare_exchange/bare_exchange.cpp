#include "bench/bare_exchange/bare_exchange.hpp"

#include "bench/bare_exchange/bare_ports.hpp"

namespace farrier::bench {
namespace {

using namespace signals;
using participant::In;
using participant::Out;

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
  if (port != nullptr) {
    port->flush();
  }
}

class BareMember final : public participant::Application {
 public:
  BareMember(BarePorts ports, participant::Participant& member, Tick ticks)
      : ports_(std::move(ports)),
        member_(member),
        ticks_(ticks),
        sensors_(ports_.sensors, ports_.joints.size()),
        commands_(ports_.commands, ports_.joints.size()),
        valves_(ports_.valves, ports_.joints.size()),
        measurements_(ports_.measurements, ports_.joints.size()),
        clock_(ports_.clock, 1),
        imu_(ports_.imu, 1),
        done_(ports_.done, member.identity().participants - 1u) {}

  void poll(SteadyTime now) override;
  bool finished() const override { return tick_ >= ticks_; }
  int missing() const override { return 1; }
  std::string waits_for() const override { return "samples of tick " + std::to_string(tick_); }

 private:
  bool leads() const noexcept { return member_.identity().number == participant::kSimBridge; }
  bool complete() const noexcept;
  void send(Tick tick);

  BarePorts ports_;
  participant::Participant& member_;
  Tick ticks_;
  Tick tick_ = 0;
  bool primed_ = false;
  Counted<JointSensors> sensors_;
  Counted<JointCommand> commands_;
  Counted<JointValveCommand> valves_;
  Counted<JointMeasurement> measurements_;
  Counted<ClockTick> clock_;
  Counted<BodyImu> imu_;
  Counted<ClockTickDone> done_;
};

bool BareMember::complete() const noexcept {
  return sensors_.has(tick_) && commands_.has(tick_) && valves_.has(tick_) && measurements_.has(tick_) &&
         clock_.has(tick_) && imu_.has(tick_) && done_.has(tick_);
}

void BareMember::send(Tick tick) {
  send_all(ports_.sensors_out, ports_.joints, tick);
  send_all(ports_.commands_out, ports_.joints, tick + 1);
  send_all(ports_.valves_out, ports_.joints, tick);
  send_all(ports_.measurements_out, ports_.joints, tick);
  send_all(ports_.imu_out, {0}, tick);
  send_all(ports_.truth_out, {0}, tick);
  send_all(ports_.state_out, {0}, tick);
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
  imu_.drain();
  done_.drain();
  if (!member_.started(now) || finished()) {
    return;
  }
  if (!primed_) {
    // The commands of tick 0 and, from the leader, tick 0 itself.
    send_all(ports_.commands_out, ports_.joints, 0);
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

}  // namespace

Result<std::unique_ptr<participant::Application>> create_bare(const robot::Robot& robot,
                                                              const std::vector<std::string>& joints, bool has_body,
                                                              participant::Participant& participant, Tick ticks) {
  auto ports = FARRIER_TRY(BarePorts::open(robot, joints, has_body, participant));
  return std::unique_ptr<participant::Application>(std::make_unique<BareMember>(std::move(ports), participant, ticks));
}

}  // namespace farrier::bench
