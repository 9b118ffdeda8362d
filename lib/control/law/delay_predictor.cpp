#include "control/law/delay_predictor.hpp"

#include <algorithm>

namespace farrier::control {
namespace {

// Shares of the difference between measurement and expectation. A velocity share of a tenth is better on a bench, where
// only noise is unknown, and four times worse in a trot, where bodies push.
constexpr double kVelocityShare = 0.3;
constexpr double kForceShare = 0.5;
// The same for the disturbances beside the model. A correction of the force comes back after the delay: the longer the
// delay, the slower the correction must be.
constexpr double kAccelerationShare = 0.03;
constexpr double kMostFlowShare = 0.3;
constexpr double kFlowShareTicks = 0.6;
// Share of the reference's last change in the change that is expected next.
constexpr double kReferenceShare = 0.3;

}  // namespace

DelayPredictor::DelayPredictor(double delay_s, double period_s, int loop_delay_ticks) noexcept
    : loop_ticks_(static_cast<std::size_t>(std::clamp(loop_delay_ticks, 0, kMaxDelayTicks))) {
  const double ticks = std::clamp(delay_s / period_s, 0.0, static_cast<double>(kMostTicks - loop_ticks_));
  whole_ = static_cast<std::size_t>(ticks);
  share_ = ticks - static_cast<double>(whole_);
  active_ = ticks > 0.0;
  flow_share_ = std::min(kMostFlowShare, kFlowShareTicks / std::max(ticks, 1.0));
}

double DelayPredictor::acting_A(std::ptrdiff_t ticks_ago) const noexcept {
  // sent_A_[i] was asked for 1 + i ticks ago and begins to act loop_ticks_ + whole_ + share_ after that.
  const auto newest = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(whole_ + loop_ticks_) + ticks_ago - 1);
  return (1.0 - share_) * sent_A_[newest] + share_ * sent_A_[newest + 1];
}

Measurement DelayPredictor::predict(const DiscreteModel& model, const Measurement& now) noexcept {
  if (!active_) {
    return now;
  }
  const Vector measured(now.position, now.velocity, now.force);
  Vector state = measured;
  if (has_last_) {
    const Vector expected = model.a * last_ + model.b * acting_A(1) + beside_;
    const Vector beyond = measured - expected;
    state = expected + Vector(beyond[0], kVelocityShare * beyond[1], kForceShare * beyond[2]);
    beside_ += Vector(0.0, kAccelerationShare * beyond[1], flow_share_ * beyond[2]);
  }
  last_ = state;
  has_last_ = true;
  for (std::size_t i = 0; i < whole_; ++i) {
    state = model.a * state + model.b * acting_A(-static_cast<std::ptrdiff_t>(i)) + beside_;
  }
  if (share_ > 0.0) {
    state += share_ * (model.a * state + model.b * sent_A_[loop_ticks_] + beside_ - state);
  }
  if (!state.allFinite()) {
    reset();
    return now;
  }
  return {state[0], state[1], state[2]};
}

double DelayPredictor::predict(double reference) noexcept {
  if (!active_) {
    return reference;
  }
  slope_ += kReferenceShare * ((has_reference_ ? reference - reference_ : 0.0) - slope_);
  reference_ = reference;
  has_reference_ = true;
  return reference + (static_cast<double>(whole_) + share_) * slope_;
}

void DelayPredictor::sent(double current_A) noexcept {
  std::move_backward(sent_A_.begin(), sent_A_.end() - 1, sent_A_.end());
  sent_A_[0] = current_A;
}

void DelayPredictor::reset() noexcept {
  sent_A_ = {};
  has_last_ = false;
  has_reference_ = false;
  slope_ = 0.0;
  beside_.setZero();
}

}  // namespace farrier::control
