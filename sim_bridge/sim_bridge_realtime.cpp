#include "sim_bridge/sim_bridge_realtime.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

#include "core/fault.hpp"
#include "core/latest_value.hpp"
#include "core/spsc_ring.hpp"
#include "participant/arrival.hpp"
#include "participant/clock.hpp"
#include "participant/loop_statistics.hpp"
#include "robot/keys.hpp"
#include "sim_bridge/ports.hpp"
#include "sim_bridge/trace_thread.hpp"

namespace farrier::sim_bridge {
namespace {

using namespace std::chrono_literals;

struct ReceivedValve {
  signals::JointValveCommand command{};
  SteadyTime received{};
};

/// Everything that crosses between the threads for one joint.
struct Mailbox {
  LatestValue<ReceivedValve> valve;
  SpscRing<signals::JointSensors, 16> sensors;
  SpscRing<trace::TraceRow, 64> rows;
  participant::Arrival arrival;  ///< bus thread
  ReceivedValve last_valve;      ///< control thread
  Tick acting_tick = kNoTick;    ///< control thread: of the valve command that acts; none while commands are silent
  trace::TraceRow row;           ///< control thread: the newest, until the reference that answers it is there
  std::atomic<bool> fell_silent{false};  ///< the valve commands, by the control thread, which puts the spool to null
  bool told_silent = false;              ///< bus thread
};

class SimBridgeRealtime final : public participant::RealtimeApplication {
 public:
  SimBridgeRealtime(Parts parts, const robot::Robot& robot, participant::Participant& participant, Tick ticks)
      : world_(std::move(parts.world)),
        ports_(parts.ports),
        participant_(participant),
        period_(std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(robot.period_s))),
        silent_after_(
            std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(robot.safety.valve_silent_s))),
        ticks_(ticks),
        numbers_(robot::joint_numbers(robot)),
        mail_(numbers_.size()),
        commands_(numbers_.size(), 0.0),
        supply_alarm_(supply_alarm(robot)),
        traces_(std::move(parts.traces)) {}

  bool receive(SteadyTime now) override;
  void step(const participant::Wake& wake) noexcept override;
  void send() override;
  void send_at_leisure() override;
  bool finished() const override { return ticks_ > 0 && tick_.load(std::memory_order_relaxed) >= ticks_; }
  Nanoseconds period() const override { return period_; }
  Trigger trigger() const override { return Trigger::kDeadline; }
  std::string waits_for() const override { return participant_.greeting_lacks(); }

 private:
  void fetch_valve(Mailbox& mail) noexcept;
  void apply_valve(std::size_t index, SteadyTime now) noexcept;
  bool trace_complete() const;
  void tell_silences();
  void report(bool final_report);

  std::unique_ptr<SimulatedRobot> world_;
  Ports ports_;
  participant::Participant& participant_;
  Nanoseconds period_;
  Nanoseconds silent_after_;
  Tick ticks_;
  std::vector<std::uint16_t> numbers_;
  std::vector<Mailbox> mail_;
  std::vector<double> commands_;  ///< for the world: valve currents or force references
  participant::LoopStatistics statistics_;
  SteadyTime next_health_{};
  std::atomic<Tick> tick_{0};
  std::atomic<Tick> sensed_tick_{kNoTick};  ///< newest whose sensors are on their way
  Tick sending_tick_ = 0;                   ///< sender thread: all before this tick is in its hands
  Tick told_tick_ = kNoTick;                ///< sender thread: newest that the clock has told
  std::atomic<Tick> sent_tick_{kNoTick};    ///< all before this tick is sent, and the trace's in its thread's hands
  bool reported_final_ = false;
  SpscRing<signals::BodyImu, 16> imus_;
  SpscRing<signals::BodyTruth, 64> truths_;  ///< to publish
  SpscRing<signals::BodyTruth, 64> rows_;    ///< for the trace
  SpscRing<trace::SupplyRow, 16> supplies_;
  SpscRing<trace::SupplyRow, 16> supply_rows_;         ///< for the trace
  SpscRing<signals::SupplyState, 16> supplies_heard_;  ///< for the alarm
  LowAlarm supply_alarm_;                              ///< bus thread
  std::atomic<bool> failed_{false};                    ///< the world, by the control thread
  TraceThreads traces_;
};

bool SimBridgeRealtime::receive(SteadyTime now) {
  ports_.valves->drain([&](const signals::JointValveCommand& valve) {
    if (!finished()) {  // joints go on answering the last sensors there were
      statistics_.answered(valve.sample_time_ns, now);
    }
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      if (numbers_[i] != valve.joint || !std::isfinite(valve.valve_current_A)) {
        continue;
      }
      if (const auto came = mail_[i].arrival.take(valve.tick, valve.sample_time_ns, now)) {
        mail_[i].valve.store({valve, *came});
      }
    }
  });
  if (!participant_.started(now)) {
    return false;
  }
  tell_silences();
  if (failed_.load(std::memory_order_relaxed)) {
    const std::string why = world_->failure().value_or("");
    participant_.event(participant::EventKind::kWorldFailed, tick_.load(std::memory_order_relaxed), signals::kNoJoint,
                       why);
    participant_.give_up(why);
  }
  if (ticks_ > 0 && sent_tick_.load(std::memory_order_acquire) >= ticks_ && traces_.finished() && !reported_final_) {
    reported_final_ = true;
    if (traces_.joints && !trace_complete()) {
      participant_.event(participant::EventKind::kTraceIncomplete, ticks_, signals::kNoJoint);
    }
    report(true);
  } else if (now >= next_health_ && !reported_final_) {
    next_health_ = now + 100ms;
    report(false);
  }
  return true;
}

bool SimBridgeRealtime::trace_complete() const {
  return traces_.complete() && rows_.dropped() == 0 && supply_rows_.dropped() == 0 &&
         std::ranges::all_of(mail_, [](const Mailbox& mail) { return mail.rows.dropped() == 0; });
}

void SimBridgeRealtime::tell_silences() {
  using enum participant::EventKind;
  for (signals::SupplyState supply; supplies_heard_.pop(supply);) {
    tell_supply(supply_alarm_, supply, participant_);
  }
  for (std::size_t i = 0; i < mail_.size() && !finished(); ++i) {
    if (const bool silent = mail_[i].fell_silent.load(std::memory_order_relaxed); silent != mail_[i].told_silent) {
      mail_[i].told_silent = silent;
      participant_.event(silent ? kValveSilent : kValveHeard, tick_.load(std::memory_order_relaxed), numbers_[i]);
    }
  }
}

void SimBridgeRealtime::report(bool final_report) {
  signals::SystemHealth health;
  statistics_.fill(health);
  participant_.report_health(tick_.load(std::memory_order_relaxed), final_report, health);
}

// At tick k the newest command there is answers the sensors of tick k - 1: one tick of loop delay. Its force reference
// belongs to what was sensed then, and so to the row of that tick.
void SimBridgeRealtime::fetch_valve(Mailbox& mail) noexcept {
  mail.valve.fetch(mail.last_valve);
  if (traces_.joints && mail.row.tick != kNoTick) {
    mail.row.force_reference_N_or_Nm = mail.last_valve.command.force_reference_N_or_Nm;
    mail.rows.push(mail.row);
  }
}

void SimBridgeRealtime::apply_valve(std::size_t index, SteadyTime now) noexcept {
  Mailbox& mail = mail_[index];
  fetch_valve(mail);
  const signals::JointValveCommand& valve = mail.last_valve.command;
  const bool begun = mail.last_valve.received != SteadyTime{};
  const bool silent = !begun || now - mail.last_valve.received > silent_after_;
  mail.fell_silent.store(begun && silent, std::memory_order_relaxed);
  const double valve_current_A = silent ? 0.0 : valve.valve_current_A;
  const double force = silent ? 0.0 : valve.force_reference_N_or_Nm;
  commands_[index] = world_->takes_forces() ? force : valve_current_A;
  mail.acting_tick = silent ? kNoTick : valve.tick;

  trace::TraceRow& row = mail.row;
  world_->describe(index, row);
  row.valve_current_A = valve_current_A;
  row.phase = valve.phase;
  row.state = silent ? signals::JointState::kNull : valve.state;
  row.generation = valve.generation;
  FaultSet faults(valve.faults);
  faults.set(Fault::kActuatorSilent, silent);
  row.faults = faults.bits();
  row.command_age_ticks = static_cast<std::uint32_t>(world_->tick() - valve.tick);
}

void SimBridgeRealtime::step(const participant::Wake& wake) noexcept {
  statistics_.stepped(wake);
  if (sensed_tick_.load(std::memory_order_relaxed) == world_->tick()) {
    // Not after sensing: the sender thread, on the same processor, would wait for it.
    if (!world_->advance(commands_)) {
      failed_.store(true, std::memory_order_relaxed);
      return;
    }
    if (world_->tick() == ticks_) {
      std::ranges::for_each(mail_, [this](Mailbox& mail) { fetch_valve(mail); });  // completes the last rows
    }
    tick_.store(world_->tick(), std::memory_order_release);
    if (finished()) {
      return;
    }
  }
  const auto sampled = std::chrono::duration_cast<Nanoseconds>(participant::steady_now().time_since_epoch()).count();
  for (std::size_t i = 0; i < mail_.size(); ++i) {
    signals::JointSensors sensors = world_->sample(i);
    sensors.sample_time_ns = sampled;
    sensors.valve_command_tick = mail_[i].acting_tick;
    mail_[i].sensors.push(sensors);
    apply_valve(i, wake.now);
  }
  if (const auto truth = world_->truth()) {
    imus_.push(imu_sample(*world_, sampled));
    truths_.push(*truth);
    if (traces_.body) {
      rows_.push(*truth);
    }
  }
  if (const auto supply = new_supply_sample(*world_)) {
    supplies_.push(*supply);
    supplies_heard_.push(supply->state);
    if (traces_.supply) {
      supply_rows_.push(*supply);
    }
  }
  sensed_tick_.store(world_->tick(), std::memory_order_release);
}

void SimBridgeRealtime::send() {
  sending_tick_ = tick_.load(std::memory_order_acquire);
  const Tick sensed = sensed_tick_.load(std::memory_order_acquire);
  for (Mailbox& mail : mail_) {
    publish_all(mail.sensors, ports_.sensors);
  }
  ports_.sensors->flush();
  publish_all(imus_, ports_.imu);
  publish_all(truths_, ports_.truth);
  for (trace::SupplyRow supply; supplies_.pop(supply);) {
    ports_.supply->publish(supply.state);
    ports_.supply_truth->publish(supply.truth);
  }
  if (sensed != told_tick_) {
    told_tick_ = sensed;
    ports_.clock->publish({0, sensed});
  }
}

void SimBridgeRealtime::send_at_leisure() {
  for (bool any = true; any && traces_.joints;) {
    any = false;
    for (Mailbox& mail : mail_) {
      if (trace::TraceRow row; mail.rows.pop(row)) {
        traces_.joints->write(row);
        any = true;
      }
    }
  }
  for (signals::BodyTruth truth; rows_.pop(truth);) {
    traces_.body->write(truth);
  }
  for (trace::SupplyRow supply; supply_rows_.pop(supply);) {
    traces_.supply->write(supply);
  }
  if (ticks_ > 0 && sending_tick_ >= ticks_) {
    traces_.end();
  }
  sent_tick_.store(sending_tick_, std::memory_order_release);
}

}  // namespace

Result<std::unique_ptr<participant::RealtimeApplication>> create_realtime(std::unique_ptr<SimulatedRobot> world,
                                                                          const robot::Robot& robot,
                                                                          const std::string& trace_path,
                                                                          participant::Participant& participant,
                                                                          Tick ticks) {
  auto parts = FARRIER_TRY(Parts::assemble(std::move(world), robot, trace_path, participant));
  return std::unique_ptr<participant::RealtimeApplication>(
      std::make_unique<SimBridgeRealtime>(std::move(parts), robot, participant, ticks));
}

}  // namespace farrier::sim_bridge
