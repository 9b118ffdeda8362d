#include "joint_node/joint_node_realtime.hpp"

#include <algorithm>
#include <limits>

#include "core/latest_value.hpp"
#include "core/spsc_ring.hpp"
#include "joint_node/gains_check.hpp"
#include "participant/arrival.hpp"
#include "participant/silence.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::joint_node {
namespace {

using namespace std::chrono_literals;

template <class Signal>
struct Stamped {
  Signal signal{};
  SteadyTime received{};  ///< when it would have come had nothing held it up
};

struct GainsUpdate {
  signals::JointControllerGains signal;
  bool refused = false;
};

/// Everything that crosses between the threads for one joint.
struct Mailbox {
  LatestValue<Stamped<signals::JointSensors>> sensors;
  LatestValue<Stamped<signals::JointCommand>> command;
  LatestValue<signals::SystemMode> mode;
  SpscRing<GainsUpdate, 16> gains;
  SpscRing<signals::GaitPhase, 16> phases;
  SpscRing<JointNode::Outputs, 16> outputs;
  LatestValue<signals::JointValveCommand> answered;  ///< for the bus thread, which makes events of its faults

  participant::Arrival sensors_arrival, command_arrival;  ///< bus thread
  Tick newest_sensors = kNoTick;               ///< bus thread
  Stamped<signals::JointSensors> last_sensors; ///< control thread
  Stamped<signals::JointCommand> last_command; ///< control thread
};

/// Two and a half leases of the mode (docs/architecture.md): a supervisor that stands by has taken over by then.
constexpr Nanoseconds kSupervisorSilence = 50ms;

/// Measurement that waits in the sender thread until the valve commands have been sent.
struct Measured {
  std::size_t joint;  ///< place among the hosted
  signals::JointMeasurement measurement;
};

double age_s(SteadyTime received, SteadyTime now) noexcept {
  return received == SteadyTime{} ? std::numeric_limits<double>::infinity()
                                  : std::chrono::duration<double>(now - received).count();
}

class JointNodeRealtime final : public participant::RealtimeApplication {
 public:
  JointNodeRealtime(std::vector<HostedJoint> joints, Ports ports, participant::Participant& participant,
                    Nanoseconds period)
      : joints_(std::move(joints)), mail_(joints_.size()), ports_(ports), participant_(participant), period_(period) {}

  bool receive(SteadyTime now) override;
  void step(const participant::Wake& wake) noexcept override;
  void send() override;
  void send_at_leisure() override;
  bool finished() const override { return false; }
  Nanoseconds period() const override { return period_; }
  Trigger trigger() const override { return Trigger::kArrival; }
  std::string waits_for() const override { return participant_.greeting_lacks(); }

 private:
  template <class Use>
  void with_mail_of(std::uint16_t joint, Use&& use) {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (joints_[i].number == joint) {
        use(mail_[i]);
      }
    }
  }
  bool all_fresh() const noexcept;

  std::vector<HostedJoint> joints_;
  std::vector<Mailbox> mail_;
  Ports ports_;
  participant::Participant& participant_;
  Nanoseconds period_;
  Tick stepped_for_ = kNoTick;  ///< bus thread: newest tick for which the control thread was woken
  SteadyTime next_health_{};
  participant::Silence supervisor_{kSupervisorSilence, participant::EventKind::kSupervisorSilent,
                                   participant::EventKind::kSupervisorHeard};  ///< bus thread
  std::vector<Measured> measured_;  ///< sender thread
  SteadyTime last_step_{};          ///< control thread
  std::atomic<std::uint64_t> periods_{0};
  std::atomic<std::uint64_t> missed_{0};
  std::atomic<Tick> last_tick_{kNoTick};
};

bool JointNodeRealtime::all_fresh() const noexcept {
  for (const Mailbox& mail : mail_) {
    if (mail.newest_sensors <= stepped_for_) {
      return false;
    }
  }
  return true;
}

bool JointNodeRealtime::receive(SteadyTime now) {
  ports_.sensors->drain([&](const signals::JointSensors& sensors) {
    with_mail_of(sensors.joint, [&](Mailbox& mail) {
      if (const auto came = mail.sensors_arrival.take(sensors.tick, sensors.sample_time_ns, now)) {
        mail.sensors.store({sensors, *came});
        mail.newest_sensors = sensors.tick;
        stepped_for_ = std::min(stepped_for_, sensors.tick - 1);  // a restarted source begins at a smaller tick
      }
    });
  });
  ports_.commands->drain([&](const signals::JointCommand& command) {
    with_mail_of(command.joint, [&](Mailbox& mail) {
      if (const auto came = mail.command_arrival.take(command.tick, command.sample_time_ns, now)) {
        mail.command.store({command, *came});
      }
    });
  });
  ports_.gains->drain([&](const signals::JointControllerGains& gains) {
    const auto joint = std::ranges::find(joints_, gains.joint, &HostedJoint::number);
    if (joint == joints_.end() || !participant_.obey({.authority = gains.authority}, last_tick_)) {
      return;
    }
    const auto checked = check_gains(gains, joint->kind);
    if (!checked) {
      participant_.event(participant::EventKind::kGainsRefused, last_tick_, gains.joint, checked.error().message);
    }
    with_mail_of(gains.joint, [&](Mailbox& mail) { mail.gains.push({gains, !checked}); });
  });
  ports_.phases->drain([&](const signals::GaitPhase& phase) {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (joints_[i].leg == phase.leg) {
        mail_[i].phases.push(phase);
      }
    }
  });
  ports_.modes->drain([&](const signals::SystemMode& mode) {
    if (!participant_.obey({mode.authority, mode.epoch}, last_tick_)) {
      return;
    }
    supervisor_.heard(now);
    for (Mailbox& mail : mail_) {
      mail.mode.store(mode);
    }
  });
  if (!participant_.started(now)) {
    return false;
  }
  if (all_fresh()) {
    stepped_for_ = mail_.front().newest_sensors;
    for (const Mailbox& mail : mail_) {
      stepped_for_ = std::min(stepped_for_, mail.newest_sensors);
    }
    inputs_complete.post();
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (signals::JointValveCommand answered; mail_[i].answered.fetch(answered)) {
      report_faults(joints_[i], answered, participant_);
    }
  }
  if (const auto kind = supervisor_.look(now)) {
    participant_.event(*kind, last_tick_, signals::kNoJoint);
  }
  if (now >= next_health_) {
    next_health_ = now + 100ms;
    signals::SystemHealth health;
    health.periods = periods_;
    health.missed_periods = missed_;
    participant_.report_health(last_tick_, false, health);
  }
  return true;
}

void JointNodeRealtime::step(const participant::Wake& wake) noexcept {
  periods_.fetch_add(1, std::memory_order_relaxed);
  missed_.fetch_add(wake.missed, std::memory_order_relaxed);
  const double since_last_step_s = last_step_ == SteadyTime{} ? 0.0 : age_s(last_step_, wake.now);
  last_step_ = wake.now;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    Mailbox& mail = mail_[i];
    JointNode& node = joints_[i].node;
    mail.sensors.fetch(mail.last_sensors);
    mail.command.fetch(mail.last_command);
    if (signals::SystemMode mode; mail.mode.fetch(mode)) {
      node.set_mode(mode);
    }
    for (GainsUpdate update; mail.gains.pop(update);) {
      if (update.refused) {
        node.refuse_gains(update.signal);
      } else {
        node.store_gains(update.signal, wire_gains::unpack_gains(update.signal));
      }
    }
    for (signals::GaitPhase phase; mail.phases.pop(phase);) {
      node.announce_phase(phase);
    }
    JointNode::Inputs inputs;
    inputs.tick = mail.last_sensors.signal.tick;
    inputs.sensors = mail.last_sensors.signal;
    inputs.sensors_age_s = age_s(mail.last_sensors.received, wake.now);
    inputs.command = mail.last_command.signal;
    inputs.command_age_s = age_s(mail.last_command.received, wake.now);
    inputs.since_last_step_s = since_last_step_s;
    const JointNode::Outputs outputs = node.step(inputs);
    mail.outputs.push(outputs);
    mail.answered.store(outputs.valve);
    last_tick_.store(inputs.tick, std::memory_order_relaxed);
  }
}

void JointNodeRealtime::send() {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    for (JointNode::Outputs outputs; mail_[i].outputs.pop(outputs);) {
      ports_.valves->publish(outputs.valve);
      measured_.push_back({i, outputs.measurement});
    }
  }
  ports_.valves->flush();
}

void JointNodeRealtime::send_at_leisure() {
  for (const Measured& measured : measured_) {
    ports_.tell(joints_[measured.joint], measured.measurement);
  }
  ports_.measurements->flush();
  ports_.summaries->flush();
  measured_.clear();
}

}  // namespace

Result<std::unique_ptr<participant::RealtimeApplication>> create_realtime(const robot::Robot& robot,
                                                                          const std::vector<std::string>& joints,
                                                                          participant::Participant& participant) {
  auto hosted = FARRIER_TRY(host_joints(robot, joints, robot.loop_delay_realtime, participant.identity().session));
  auto ports = FARRIER_TRY(Ports::open(participant, hosted, robot));
  const auto period = std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(robot.period_s));
  return std::unique_ptr<participant::RealtimeApplication>(
      std::make_unique<JointNodeRealtime>(std::move(hosted), ports, participant, period));
}

}  // namespace farrier::joint_node
