#include "participant/plain_processes.hpp"

#include <algorithm>
#include <cmath>

#include "estimator_service/estimator_service.hpp"
#include "participant/sequence.hpp"
#include "robot/keys.hpp"

namespace farrier::estimator_service {
namespace {

using namespace std::chrono_literals;

constexpr double kCopyPeriod_s = 0.1;

/// Whole periods of estimates, the first that last as long as a copy's.
Tick copy_period_ticks(const robot::Robot& robot) {
  const double estimates = kCopyPeriod_s / (robot.estimate_period_ticks * robot.period_s);
  return robot.estimate_period_ticks * std::max<Tick>(1, std::llround(estimates));
}

/// True if an estimator of the robot takes the supply's pressure.
bool asks_for_supply(const robot::Robot& robot) {
  return std::ranges::any_of(robot.joints, [](const robot::Joint& joint) { return joint.estimator.finds_valve(); });
}

class EstimatorApplication final : public participant::Application {
 public:
  EstimatorApplication(const robot::Robot& robot, EstimatorService service, std::vector<std::uint16_t> joints,
                       participant::In<signals::JointMeasurement>* measurements,
                       participant::In<signals::SupplyState>* supply,
                       participant::Out<signals::JointModelEstimate>* estimates,
                       participant::Out<signals::JointModelEstimateCopy>* copies, participant::Participant& participant,
                       Tick ticks)
      : robot_(robot),
        service_(std::move(service)),
        measurements_(measurements),
        supply_(supply),
        estimates_(estimates),
        copies_(copies),
        copy_period_ticks_(copy_period_ticks(robot)),
        participant_(participant),
        lockstep_(participant.identity().clock == bus::ClockKind::kLockstep),
        ticks_(ticks),
        sequences_(joints.size()),
        inbox_(std::move(joints)) {}

  void poll(SteadyTime now) override;
  bool finished() const override { return lockstep_ && ticks_ > 0 && tick_ >= ticks_; }
  int missing() const override { return lockstep_ ? std::max(1, inbox_.missing(tick_)) : 1; }
  std::string waits_for() const override;

 private:
  void take(const signals::JointMeasurement& measurement, SteadyTime now);
  void step_lockstep(SteadyTime now);
  bool lacks_supply() const noexcept { return supply_ != nullptr && supply_tick_ < robot_.due_supply(tick_); }

  const robot::Robot& robot_;
  EstimatorService service_;
  participant::In<signals::JointMeasurement>* measurements_;
  participant::In<signals::SupplyState>* supply_;  ///< null where no estimator asks for it
  participant::Out<signals::JointModelEstimate>* estimates_;
  participant::Out<signals::JointModelEstimateCopy>* copies_;  ///< sent by flush()
  Tick copy_period_ticks_;
  participant::Participant& participant_;
  bool lockstep_;
  Tick ticks_;
  Tick tick_ = 0;
  Tick supply_tick_ = kNoTick;                    ///< of the newest
  std::vector<participant::Sequence> sequences_;  ///< of measurements, by joint
  participant::TickInbox<signals::JointMeasurement> inbox_;
  SteadyTime next_health_{};
  bool said_ = false;  ///< that it has started; real time only
};

void EstimatorApplication::take(const signals::JointMeasurement& measurement, SteadyTime now) {
  if (measurement.joint >= sequences_.size() || !sequences_[measurement.joint].take(measurement.tick, now)) {
    return;  // a joint whose next sensors are late answers the last ones again
  }
  service_.take(measurement);
  if (robot_.estimate_due(measurement.tick)) {
    const signals::JointModelEstimate estimate = service_.estimate(measurement.joint, measurement.tick);
    estimates_->publish(estimate);
    if (measurement.tick % copy_period_ticks_ == 0) {
      copies_->publish({estimate});
    }
  }
}

void EstimatorApplication::step_lockstep(SteadyTime now) {
  while (!finished() && inbox_.missing(tick_) == 0 && !lacks_supply()) {
    for (std::size_t i = 0; i < inbox_.keys().size(); ++i) {
      take(*inbox_.find(i, tick_), now);
    }
    copies_->flush();
    participant_.tick_done(tick_);
    ++tick_;
    if (finished()) {
      participant_.report_health(tick_, true);
    }
  }
}

void EstimatorApplication::poll(SteadyTime now) {
  if (supply_ != nullptr) {
    supply_->drain([this](const signals::SupplyState& supply) {
      service_.take(supply);
      supply_tick_ = supply.tick;
    });
  }
  measurements_->drain([&](const signals::JointMeasurement& measurement) {
    if (lockstep_) {
      inbox_.put(measurement);
    } else {
      take(measurement, now);
      tick_ = std::max(tick_, measurement.tick);
    }
  });
  if (!participant_.started(now)) {
    return;
  }
  if (lockstep_) {
    step_lockstep(now);
    return;
  }
  copies_->flush();
  if (!said_) {
    said_ = true;
    participant_.event(participant::EventKind::kEstimatesBegin, tick_, signals::kNoJoint);
  }
  if (now >= next_health_) {
    next_health_ = now + 100ms;
    participant_.report_health(tick_, false);
  }
}

std::string EstimatorApplication::waits_for() const {
  const std::string lacking = participant_.greeting_lacks();
  if (lacking.empty() && lockstep_ && inbox_.missing(tick_) == 0 && lacks_supply()) {
    return "supply/state at tick " + std::to_string(robot_.due_supply(tick_));
  }
  return lacking.empty() ? "joint/measurement of joint " + std::to_string(inbox_.first_missing(tick_)) + " at tick " +
                               std::to_string(tick_)
                         : lacking;
}

}  // namespace

Result<std::unique_ptr<participant::Application>> create_application(const robot::Robot& robot,
                                                                     participant::World world,
                                                                     participant::Participant& participant,
                                                                     Tick ticks) {
  const bool lockstep = participant.identity().clock == bus::ClockKind::kLockstep;
  auto service =
      FARRIER_TRY(EstimatorService::create(robot, lockstep ? robot.loop_delay_lockstep : robot.loop_delay_realtime));
  const std::vector<std::uint16_t> joints = robot::joint_numbers(robot);
  auto measurements = FARRIER_TRY(participant.subscribe<signals::JointMeasurement>(joints));
  const bool hears_supply = participant::tells_supply(world, robot.supply.has_value()) && asks_for_supply(robot);
  auto supply = hears_supply ? FARRIER_TRY(participant.subscribe<signals::SupplyState>({0})) : nullptr;
  auto estimates = FARRIER_TRY(participant.publish<signals::JointModelEstimate>(joints));
  auto copies = FARRIER_TRY(participant.publish<signals::JointModelEstimateCopy>(joints));
  return std::unique_ptr<participant::Application>(std::make_unique<EstimatorApplication>(
      robot, std::move(service), joints, measurements, supply, estimates, copies, participant, ticks));
}

}  // namespace farrier::estimator_service
