#include "supervisor/ports.hpp"

#include <algorithm>

#include "participant/sequence.hpp"
#include "participant/silence.hpp"
#include "robot/keys.hpp"
#include "supervisor/succession.hpp"

namespace farrier::supervisor {
namespace {

using namespace std::chrono_literals;

// A quarter of the lease of the topics that carry authority, and of the silence after which another takes over.
constexpr auto kModePeriod = 5ms;

constexpr int kMissedEstimates = 5;  // of a joint in a row, before they count as silent

struct Ports {
  participant::In<signals::ClockTick>* clock;
  participant::In<signals::JointModelEstimate>* estimates;
  participant::In<signals::SystemRequest>* requests;
  participant::In<signals::JointControllerGains>* led_gains;  ///< of the leading supervisor; real time only
  participant::In<signals::SystemMode>* led_modes;            ///< of the leading supervisor; real time only
  participant::Out<signals::JointControllerGains>* gains;
  participant::Out<signals::SystemMode>* modes;
  participant::Out<signals::JointUpdateDecision>* decisions;
};

class SupervisorApplication final : public participant::Application {
 public:
  SupervisorApplication(const robot::Robot& robot, Supervisor supervisor, Ports ports,
                        std::vector<std::uint16_t> joints, participant::Participant& participant, Tick ticks,
                        bool stands_by)
      : robot_(robot),
        supervisor_(std::move(supervisor)),
        ports_(ports),
        participant_(participant),
        lockstep_(participant.identity().clock == bus::ClockKind::kLockstep),
        ticks_(ticks),
        succession_(stands_by),
        estimates_(std::move(joints)),
        silence_(std::chrono::duration_cast<Nanoseconds>(
                     std::chrono::duration<double>(kMissedEstimates * robot.estimate_period_ticks * robot.period_s)),
                 participant::EventKind::kEstimatesSilent, participant::EventKind::kEstimatesHeard) {}

  void poll(SteadyTime now) override;
  bool finished() const override { return lockstep_ && ticks_ > 0 && tick_ >= ticks_; }
  int missing() const override { return 1; }
  std::string waits_for() const override;

 private:
  bool estimates_due() const { return tick_ > 0 && robot_.estimate_due(tick_ - 1); }
  void step_lockstep();
  void step_realtime(SteadyTime now);
  void follow(SteadyTime now);
  void succeed(SteadyTime now);
  void write(const Supervisor::Outputs& outputs);
  void issue(Tick tick);
  void tell(const signals::JointUpdateDecision& decision, control::DesignStatus status);

  const robot::Robot& robot_;
  Supervisor supervisor_;
  Ports ports_;
  participant::Participant& participant_;
  bool lockstep_;
  Tick ticks_;
  Succession succession_;
  signals::SystemMode mode_;  ///< last written; epoch 0: none
  Tick tick_ = 0;             ///< next to be worked on
  Tick begun_ = kNoTick;      ///< newest the clock has begun
  participant::Sequence clock_ticks_;
  participant::TickInbox<signals::JointModelEstimate> estimates_;
  SteadyTime next_health_{};
  SteadyTime next_mode_{};
  participant::Silence silence_;  ///< of estimates, real time only
};

// A refused design is an event with its reason; an accepted one is reported by its decision.
void SupervisorApplication::tell(const signals::JointUpdateDecision& decision, control::DesignStatus status) {
  const auto verdict = decision.verdict;
  if (verdict == signals::UpdateVerdict::kAccepted) {
    return;
  }
  std::string text = std::string(signals::to_string(decision.phase)) + " gains kept: " + signals::to_string(verdict);
  if (status != control::DesignStatus::kSuccessful) {
    text += std::string(" (") + control::to_string(status) + ")";
  }
  participant_.event(participant::EventKind::kGainsKept, decision.tick, decision.joint, text);
}

void SupervisorApplication::write(const Supervisor::Outputs& outputs) {
  for (const signals::JointControllerGains& gains : outputs.gains) {
    ports_.gains->publish(gains);
  }
  for (const signals::SystemMode& mode : outputs.modes) {
    ports_.modes->publish(mode);
    mode_ = mode;
  }
}

void SupervisorApplication::issue(Tick tick) {
  const Supervisor::Outputs& outputs = supervisor_.step(tick);
  write(outputs);
  for (std::size_t i = 0; i < outputs.decisions.size(); ++i) {
    ports_.decisions->publish(outputs.decisions[i]);
    tell(outputs.decisions[i], outputs.design_statuses[i]);
  }
}

void SupervisorApplication::step_lockstep() {
  while (!finished() && begun_ >= tick_ && !(estimates_due() && estimates_.missing(tick_ - 1) > 0)) {
    for (std::size_t i = 0; estimates_due() && i < estimates_.keys().size(); ++i) {
      supervisor_.take(*estimates_.find(i, tick_ - 1), tick_);
    }
    issue(tick_);
    signals::ClockTickDone issued;
    issued.issued_gains = static_cast<std::uint32_t>(ports_.gains->sent());
    issued.issued_modes = static_cast<std::uint32_t>(ports_.modes->sent());
    participant_.tick_done(tick_, issued);
    ++tick_;
    if (finished()) {
      participant_.report_health(tick_, true);
    }
  }
}

// Follows the orders of the leading supervisor. Own samples come back too: they are not followed.
void SupervisorApplication::follow(SteadyTime now) {
  ports_.led_gains->drain([&](const signals::JointControllerGains& gains) {
    if (!succession_.leads() && gains.authority >= succession_.authority()) {
      supervisor_.mirror(gains);
    }
  });
  ports_.led_modes->drain([&](const signals::SystemMode& mode) {
    succession_.heard(mode.authority, now);
    if (!succession_.leads() && mode.authority >= succession_.authority()) {
      supervisor_.mirror(mode);
    }
  });
}

void SupervisorApplication::succeed(SteadyTime now) {
  participant_.hear_hellos();
  const participant::Orders newest = participant_.newest_orders();
  const Duty duty = succession_.step(newest.authority, now);
  const std::uint32_t authority = succession_.authority();
  switch (duty) {
    case Duty::kNone:
      break;
    case Duty::kTakeOver:
      supervisor_.take_over(authority, newest.mode_epoch, begun_);
      participant_.obey({authority, newest.mode_epoch}, begun_);
      participant_.event(participant::EventKind::kSupervisorLeads, begun_, signals::kNoJoint,
                         std::to_string(authority));
      write(supervisor_.orders());
      break;
    case Duty::kRewrite:
      write(supervisor_.orders());
      break;
    case Duty::kStandDown:
      supervisor_.stand_down();
      mode_ = {};
      participant_.event(participant::EventKind::kSupervisorStandsBy, begun_, signals::kNoJoint,
                         std::to_string(authority));
      break;
  }
}

void SupervisorApplication::step_realtime(SteadyTime now) {
  succeed(now);
  if (!succession_.leads()) {
    return;
  }
  if (begun_ != kNoTick) {
    issue(begun_);
  }
  if (const auto kind = silence_.look(now)) {
    participant_.event(*kind, begun_, signals::kNoJoint);
  }
  if (now >= next_mode_) {
    next_mode_ = now + kModePeriod;
    ports_.gains->assert_liveliness();
    if (mode_.epoch != 0) {
      ports_.modes->publish(mode_);  // supervisors that stand by monitor it
    } else {
      ports_.modes->assert_liveliness();
    }
  }
}

void SupervisorApplication::poll(SteadyTime now) {
  ports_.clock->drain([&](const signals::ClockTick& clock) {
    if (clock_ticks_.take(clock.tick, now)) {
      begun_ = clock.tick;
    }
  });
  ports_.estimates->drain([&](const signals::JointModelEstimate& estimate) {
    if (lockstep_) {
      estimates_.put(estimate);
      return;
    }
    silence_.heard(now);
    if (succession_.leads() && estimate.tick >= 0 && estimate.tick <= begun_ + participant::Sequence::kFarthest) {
      supervisor_.take(estimate, estimate.tick);
    }
  });
  if (!lockstep_) {
    follow(now);
  }
  ports_.requests->drain([&](const signals::SystemRequest& request) {
    if (!lockstep_ && !succession_.leads()) {
      return;  // the leading supervisor answers
    }
    supervisor_.take(request);
    participant_.event(participant::EventKind::kOperatorRequest, begun_, signals::kNoJoint,
                       signals::to_string(request.request));
  });
  if (!participant_.started(now)) {
    return;
  }
  if (lockstep_) {
    step_lockstep();
    return;
  }
  step_realtime(now);
  if (now >= next_health_) {
    next_health_ = now + 100ms;
    participant_.report_health(begun_, false);
  }
}

std::string SupervisorApplication::waits_for() const {
  const std::string lacking = participant_.greeting_lacks();
  if (!lacking.empty()) {
    return lacking;
  }
  return (begun_ < tick_ ? "clock/tick " : "joint/model_estimate for tick ") + std::to_string(tick_);
}

}  // namespace

Result<std::unique_ptr<participant::Application>> create_application(const robot::Robot& robot, Design design,
                                                                     participant::Participant& participant, Tick ticks,
                                                                     bool stands_by,
                                                                     std::vector<robot::LoadChange> known_loads,
                                                                     const std::vector<SlotGains>& first_gains) {
  const bool lockstep = participant.identity().clock == bus::ClockKind::kLockstep;
  auto supervisor =
      FARRIER_TRY(Supervisor::create(robot, design, lockstep ? robot.loop_delay_lockstep : robot.loop_delay_realtime,
                                     participant.identity().session, std::move(known_loads), first_gains));
  const std::vector<std::uint16_t> numbers = robot::joint_numbers(robot);
  auto clock = FARRIER_TRY(participant.subscribe<signals::ClockTick>({0}));
  auto estimates = FARRIER_TRY(participant.subscribe<signals::JointModelEstimate>(numbers));
  auto requests = participant.subscribe<signals::SystemRequest>({});  // an operator may come, or never
  if (!requests) {
    return requests.error();
  }
  participant::In<signals::JointControllerGains>* led_gains = nullptr;
  participant::In<signals::SystemMode>* led_modes = nullptr;
  if (!lockstep) {
    auto led = FARRIER_TRY(participant.subscribe<signals::JointControllerGains>(numbers, robot::legs_of_joints(robot)));
    led_gains = led;
    auto modes_led = FARRIER_TRY(participant.subscribe<signals::SystemMode>({0}));
    led_modes = modes_led;
  }
  auto gains = FARRIER_TRY(participant.publish<signals::JointControllerGains>(numbers, robot::legs_of_joints(robot)));
  auto modes = FARRIER_TRY(participant.publish<signals::SystemMode>({0}));
  auto decisions = FARRIER_TRY(participant.publish<signals::JointUpdateDecision>(numbers));
  return std::unique_ptr<participant::Application>(std::make_unique<SupervisorApplication>(
      robot, std::move(supervisor),
      Ports{clock, estimates, requests.value(), led_gains, led_modes, gains, modes, decisions}, numbers, participant,
      ticks, stands_by));
}

}  // namespace farrier::supervisor
