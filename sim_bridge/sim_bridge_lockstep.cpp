#include "sim_bridge/sim_bridge_lockstep.hpp"

#include <optional>

#include "trace/trace.hpp"
#include "robot/keys.hpp"
#include "runtime/latency_histogram.hpp"
#include "sim_bridge/ports.hpp"

namespace farrier::sim_bridge {
namespace {

std::int64_t to_ns(SteadyTime time) { return std::chrono::duration_cast<Nanoseconds>(time.time_since_epoch()).count(); }

class SimBridgeLockstep final : public participant::Application {
 public:
  SimBridgeLockstep(Parts parts, const robot::Robot& robot, participant::Participant& participant, Tick ticks,
                    RowSink sink)
      : world_(std::move(parts.world)),
        traces_(std::move(parts.traces)),
        sink_(std::move(sink)),
        ports_(parts.ports),
        participant_(participant),
        ticks_(ticks),
        loop_delay_(robot.loop_delay_lockstep),
        valves_(robot::joint_numbers(robot)),
        valve_current_A_(robot.joints.size(), 0.0),
        commands_(robot.joints.size(), 0.0),
        valve_command_tick_(robot.joints.size(), kNoTick),
        generation_(robot.joints.size(), 0),
        supply_alarm_(supply_alarm(robot)) {
    std::vector<std::uint16_t> others;
    for (std::uint16_t number = 1; number < participant.identity().participants; ++number) {
      others.push_back(number);
    }
    done_ = participant::TickInbox<signals::ClockTickDone>(others);
  }

  void poll(SteadyTime now) override;
  bool finished() const override { return ticks_ > 0 && world_->tick() >= ticks_; }
  int missing() const override;
  std::string waits_for() const override;

 private:
  void drain();
  bool complete() const;
  void begin_tick();
  void end_tick();
  void record() noexcept;
  void report(bool final_report);

  std::unique_ptr<SimulatedRobot> world_;
  Traces traces_;
  RowSink sink_;
  Ports ports_;
  participant::Participant& participant_;
  Tick ticks_;
  int loop_delay_;  ///< ticks by which a valve command acts late, to try designs for a delay
  bool begun_ = false;
  bool failed_ = false;  ///< the world: no further tick begins
  participant::TickInbox<signals::JointValveCommand> valves_;
  participant::TickInbox<signals::ClockTickDone> done_{{}};
  std::vector<double> valve_current_A_;    ///< act over the present tick
  std::vector<double> commands_;           ///< for the world: these currents, or force references
  std::vector<Tick> valve_command_tick_;   ///< of the commands that act
  std::vector<std::uint32_t> generation_;  ///< newest issued to each joint, as seen here
  std::uint32_t received_gains_ = 0;
  std::uint32_t received_modes_ = 0;
  std::uint32_t mode_epoch_ = 0;
  runtime::LatencyHistogram latency_;
  LowAlarm supply_alarm_;
};

void SimBridgeLockstep::drain() {
  ports_.valves->drain([&](const signals::JointValveCommand& valve) {
    latency_.add(std::chrono::steady_clock::now().time_since_epoch() - Nanoseconds(valve.sample_time_ns));
    valves_.put(valve);
  });
  ports_.done->drain([&](const signals::ClockTickDone& done) { done_.put(done); });
  ports_.gains->drain([&](const signals::JointControllerGains& gains) {
    ++received_gains_;
    for (std::size_t i = 0; i < generation_.size(); ++i) {
      if (valves_.keys()[i] == gains.joint) {
        generation_[i] = std::max(generation_[i], gains.generation);
      }
    }
  });
  ports_.modes->drain([&](const signals::SystemMode& mode) {
    ++received_modes_;
    mode_epoch_ = std::max(mode_epoch_, mode.epoch);
  });
}

bool SimBridgeLockstep::complete() const {
  const Tick tick = world_->tick();
  if (valves_.missing(tick) > 0 || done_.missing(tick) > 0) {
    return false;
  }
  std::uint32_t issued_gains = 0;
  std::uint32_t issued_modes = 0;
  for (std::size_t i = 0; i < done_.keys().size(); ++i) {
    issued_gains += done_.find(i, tick)->issued_gains;
    issued_modes += done_.find(i, tick)->issued_modes;
  }
  return received_gains_ >= issued_gains && received_modes_ >= issued_modes;
}

void SimBridgeLockstep::begin_tick() {
  for (std::size_t i = 0; i < world_->joints(); ++i) {
    signals::JointSensors sensors = world_->sample(i);
    sensors.valve_command_tick = valve_command_tick_[i];
    sensors.required_generation = generation_[i];
    sensors.required_epoch = mode_epoch_;
    sensors.sample_time_ns = to_ns(std::chrono::steady_clock::now());
    ports_.sensors->publish(sensors);
  }
  ports_.sensors->flush();
  if (ports_.imu != nullptr) {
    ports_.imu->publish(imu_sample(*world_, to_ns(std::chrono::steady_clock::now())));
    ports_.truth->publish(world_->truth().value_or(signals::BodyTruth{}));
  }
  if (const auto supply = new_supply_sample(*world_)) {
    ports_.supply->publish(supply->state);
    ports_.supply_truth->publish(supply->truth);
    tell_supply(supply_alarm_, supply->state, participant_);
    if (traces_.supply) {
      traces_.supply->write(*supply);
    }
  }
  ports_.clock->publish({0, world_->tick()});
  begun_ = true;
}

void SimBridgeLockstep::record() noexcept {
  for (std::size_t i = 0; i < world_->joints(); ++i) {
    const signals::JointValveCommand& valve = *valves_.find(i, world_->tick());
    trace::TraceRow row;
    world_->describe(i, row);
    row.force_reference_N_or_Nm = valve.force_reference_N_or_Nm;
    row.valve_current_A = valve_current_A_[i];
    row.command_age_ticks = static_cast<std::uint32_t>(loop_delay_);
    row.phase = valve.phase;
    row.state = valve.state;
    row.generation = valve.generation;
    row.faults = valve.faults;
    if (traces_.joints) {
      traces_.joints->write(row);
    }
    if (sink_) {
      sink_(row);
    }
  }
  if (traces_.body) {
    traces_.body->write(world_->truth().value_or(signals::BodyTruth{}));
  }
}

void SimBridgeLockstep::end_tick() {
  for (std::size_t i = 0; i < world_->joints(); ++i) {
    const signals::JointValveCommand* acting = valves_.find(i, world_->tick() - loop_delay_);
    valve_current_A_[i] = acting != nullptr ? acting->valve_current_A : 0.0;
    const double force = acting != nullptr ? acting->force_reference_N_or_Nm : 0.0;
    commands_[i] = world_->takes_forces() ? force : valve_current_A_[i];
    valve_command_tick_[i] = acting != nullptr ? acting->tick : kNoTick;
  }
  if (traces_.joints || sink_) {
    record();
  }
  if (!world_->advance(commands_)) {
    participant_.event(participant::EventKind::kWorldFailed, world_->tick(), signals::kNoJoint,
                       world_->failure().value_or(""));
    participant_.give_up(world_->failure().value_or(""));
    failed_ = true;
  }
  begun_ = false;
}

void SimBridgeLockstep::report(bool final_report) {
  signals::SystemHealth health;
  health.latency_s = latency_.summary_s();
  participant_.report_health(world_->tick(), final_report, health);
}

void SimBridgeLockstep::poll(SteadyTime now) {
  drain();
  if (!participant_.started(now) || finished() || failed_) {
    return;
  }
  if (!begun_) {
    begin_tick();
    return;
  }
  while (complete()) {
    end_tick();
    if (failed_) {
      return;
    }
    if (finished()) {
      if (!traces_.finish()) {
        participant_.event(participant::EventKind::kTraceIncomplete, world_->tick(), signals::kNoJoint);
      }
      report(true);
      return;
    }
    begin_tick();
    drain();
  }
}

int SimBridgeLockstep::missing() const {
  const int count = valves_.missing(world_->tick()) + done_.missing(world_->tick());
  return count > 0 && begun_ ? count : 1;
}

std::string SimBridgeLockstep::waits_for() const {
  if (const std::string lacking = participant_.greeting_lacks(); !lacking.empty()) {
    return lacking;
  }
  const Tick tick = world_->tick();
  const std::string at = " at tick " + std::to_string(tick);
  if (done_.missing(tick) > 0) {
    const auto& hello = participant_.hellos()[done_.first_missing(tick)];
    return std::string(signals::text_of(hello.name)) + " to finish" + at;
  }
  if (valves_.missing(tick) > 0) {
    return "joint/valve_command of joint " + std::to_string(valves_.first_missing(tick)) + at;
  }
  if (failed_) {
    return "nothing: " + world_->failure().value_or("the world has failed");
  }
  return "gains or mode that the supervisor has issued" + at;
}

}  // namespace

Result<std::unique_ptr<participant::Application>> create_lockstep(std::unique_ptr<SimulatedRobot> world,
                                                                  const robot::Robot& robot,
                                                                  const std::string& trace_path,
                                                                  participant::Participant& participant, Tick ticks,
                                                                  RowSink sink) {
  auto parts = FARRIER_TRY(Parts::assemble(std::move(world), robot, trace_path, participant));
  return std::unique_ptr<participant::Application>(
      std::make_unique<SimBridgeLockstep>(std::move(parts), robot, participant, ticks, std::move(sink)));
}

}  // namespace farrier::sim_bridge
