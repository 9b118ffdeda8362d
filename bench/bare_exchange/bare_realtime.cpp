#include "bench/bare_exchange/bare_realtime.hpp"

#include <atomic>
#include <thread>

#include "bench/bare_exchange/bare_ports.hpp"
#include "participant/loop_statistics.hpp"
#include "runtime/awake_processors.hpp"
#include "runtime/deadline.hpp"
#include "runtime/latency_histogram.hpp"
#include "runtime/realtime_thread.hpp"

namespace farrier::bench {
namespace {

using namespace std::chrono_literals;
constexpr auto kHealthPeriod = 100ms;

class BareClock final : public participant::RealtimeApplication {
 public:
  BareClock(BarePorts ports, const robot::Robot& robot, participant::Participant& member, Tick ticks)
      : ports_(std::move(ports)),
        member_(member),
        period_(std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(robot.period_s))),
        ticks_(ticks) {}

  bool receive(SteadyTime now) override;
  void step(const participant::Wake& wake) noexcept override;
  void send() override {}
  bool finished() const override { return ticks_ > 0 && tick_ >= ticks_; }
  Nanoseconds period() const override { return period_; }
  Trigger trigger() const override { return Trigger::kDeadline; }
  bool publishes_in_step() const override { return true; }
  std::string waits_for() const override { return member_.greeting_lacks(); }

 private:
  void report(bool final_report);

  BarePorts ports_;
  participant::Participant& member_;
  Nanoseconds period_;
  Tick ticks_;
  std::atomic<Tick> tick_{0};
  participant::LoopStatistics statistics_;
  SteadyTime next_health_{};
  bool over_ = false;
};

bool BareClock::receive(SteadyTime now) {
  ports_.valves->drain(
      [&](const signals::JointValveCommand& valve) { statistics_.answered(valve.sample_time_ns, now); });
  if (!member_.started(now)) {
    return false;
  }
  if (!over_ && (finished() || now >= next_health_)) {
    over_ = finished();
    next_health_ = now + kHealthPeriod;
    report(over_);
  }
  return true;
}

void BareClock::report(bool final_report) {
  signals::SystemHealth health;
  statistics_.fill(health);
  member_.report_health(tick_, final_report, health);
}

void BareClock::step(const participant::Wake& wake) noexcept {
  statistics_.stepped(wake);
  signals::JointSensors sensors;
  sensors.tick = tick_;
  sensors.sample_time_ns = std::chrono::duration_cast<Nanoseconds>(wake.now.time_since_epoch()).count();
  for (const std::uint16_t joint : ports_.joints) {
    sensors.joint = joint;
    ports_.sensors_out->publish(sensors);
  }
  ports_.sensors_out->flush();
  ports_.clock_out->publish({0, sensors.tick});
  ++tick_;
}

class BareAnswer final : public participant::Application {
 public:
  BareAnswer(BarePorts ports, participant::Participant& member) : ports_(std::move(ports)), member_(member) {}

  void poll(SteadyTime now) override;
  bool finished() const override { return false; }
  int missing() const override { return 1; }
  std::string waits_for() const override { return member_.greeting_lacks(); }

 private:
  void answer(const signals::JointSensors& sensors);
  void command(Tick tick);

  BarePorts ports_;
  participant::Participant& member_;
  Tick tick_ = 0;  ///< newest heard of
  SteadyTime next_health_{};
};

void BareAnswer::answer(const signals::JointSensors& sensors) {
  signals::JointValveCommand valve;
  valve.joint = sensors.joint;
  valve.tick = sensors.tick;
  valve.sample_time_ns = sensors.sample_time_ns;
  ports_.valves_out->publish(valve);
  signals::JointMeasurement measurement;
  measurement.joint = sensors.joint;
  measurement.tick = sensors.tick;
  ports_.measurements_out->publish(measurement);
  tick_ = sensors.tick;
}

void BareAnswer::command(Tick tick) {
  signals::JointCommand command;
  command.tick = tick;
  for (const std::uint16_t joint : ports_.joints) {
    command.joint = joint;
    ports_.commands_out->publish(command);
  }
  ports_.commands_out->flush();
}

void BareAnswer::poll(SteadyTime now) {
  if (ports_.sensors != nullptr) {
    if (ports_.sensors->drain([&](const signals::JointSensors& sensors) { answer(sensors); }) > 0) {
      ports_.valves_out->flush();
      ports_.measurements_out->flush();
    }
    ports_.commands->drain([](const signals::JointCommand&) {});
  }
  if (ports_.measurements != nullptr) {
    ports_.measurements->drain([&](const signals::JointMeasurement& measurement) { tick_ = measurement.tick; });
  }
  if (ports_.clock != nullptr) {
    ports_.clock->drain([&](const signals::ClockTick& clock) {
      tick_ = clock.tick;
      if (ports_.commands_out != nullptr) {
        command(clock.tick + 1);
      }
    });
  }
  if (member_.started(now) && now >= next_health_) {
    next_health_ = now + kHealthPeriod;
    member_.report_health(tick_, false);
  }
}

}  // namespace

TimerLoop bare_timer_loop(Nanoseconds period, Nanoseconds duration) {
  runtime::LatencyHistogram wake_up;
  std::uint64_t missed = 0;
  std::thread timer([&] {
    // Where the limits forbid it the loop is measured without: so will the control loops be.
    static_cast<void>(runtime::set_priority(runtime::kControlPriority));
    const runtime::AwakeProcessors awake;
    SteadyTime previous = std::chrono::steady_clock::now();
    const SteadyTime end = previous + duration;
    while (previous < end) {
      const runtime::Deadline deadline = runtime::next_deadline(previous, std::chrono::steady_clock::now(), period);
      missed += deadline.missed;
      runtime::sleep_until(deadline.next);
      wake_up.add(std::chrono::steady_clock::now() - deadline.next);
      previous = deadline.next;
    }
  });
  timer.join();
  return {wake_up.summary_s(), wake_up.count(), missed};
}

Result<std::unique_ptr<participant::RealtimeApplication>> create_bare_clock(const robot::Robot& robot,
                                                                            participant::Participant& participant,
                                                                            Tick ticks) {
  auto ports = FARRIER_TRY(BarePorts::open(robot, {}, false, participant));
  return std::unique_ptr<participant::RealtimeApplication>(
      std::make_unique<BareClock>(std::move(ports), robot, participant, ticks));
}

Result<std::unique_ptr<participant::Application>> create_bare_answer(const robot::Robot& robot,
                                                                     const std::vector<std::string>& joints,
                                                                     participant::Participant& participant) {
  auto ports = FARRIER_TRY(BarePorts::open(robot, joints, false, participant));
  return std::unique_ptr<participant::Application>(std::make_unique<BareAnswer>(std::move(ports), participant));
}

}  // namespace farrier::bench
