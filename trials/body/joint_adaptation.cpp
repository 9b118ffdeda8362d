#include "trials/body/joint_adaptation.hpp"

#include <utility>

#include "estimation/estimator.hpp"

namespace farrier::trials {

AdaptationCounts& AdaptationCounts::operator+=(const AdaptationCounts& other) noexcept {
  estimates += other.estimates;
  valid += other.valid;
  updates += other.updates;
  refused += other.refused;
  invalid_updates += other.invalid_updates;
  gains_refused += other.gains_refused;
  return *this;
}

Result<JointAdaptation> JointAdaptation::create(const robot::Robot& robot, std::uint64_t session) {
  auto service = FARRIER_TRY(estimator_service::EstimatorService::create(robot, robot.loop_delay_lockstep));
  auto supervisor =
      FARRIER_TRY(supervisor::Supervisor::create(robot, robot::Design::kAdaptive, robot.loop_delay_lockstep, session));
  return JointAdaptation(robot, std::move(service), std::move(supervisor));
}

JointAdaptation::JointAdaptation(const robot::Robot& robot, estimator_service::EstimatorService service,
                                 supervisor::Supervisor supervisor)
    : validity_min_(robot.update_logic.validity_min),
      estimate_period_ticks_(robot.estimate_period_ticks),
      service_(std::move(service)),
      supervisor_(std::move(supervisor)),
      estimates_(robot.joints.size()) {}

const std::vector<signals::JointControllerGains>& JointAdaptation::begin(Tick tick) noexcept {
  if (due_) {
    for (const signals::JointModelEstimate& estimate : estimates_) {
      supervisor_.take(estimate, tick);
      ++counts_.estimates;
      counts_.valid += estimate.validity >= validity_min_ ? 1 : 0;
    }
    due_ = false;
  }
  const supervisor::Supervisor::Outputs& outputs = supervisor_.step(tick);
  for (const signals::JointUpdateDecision& decision : outputs.decisions) {
    const bool accepted = decision.verdict == signals::UpdateVerdict::kAccepted;
    ++(accepted ? counts_.updates : counts_.refused);
    counts_.invalid_updates += accepted && decision.validity < validity_min_ ? 1 : 0;
  }
  return outputs.gains;
}

void JointAdaptation::end(Tick tick) noexcept {
  if (tick % estimate_period_ticks_ == 0) {
    for (std::size_t joint = 0; joint < estimates_.size(); ++joint) {
      estimates_[joint] = service_.estimate(static_cast<std::uint16_t>(joint), tick);
    }
    due_ = true;
  }
}

}  // namespace farrier::trials
