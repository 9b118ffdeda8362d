#include "supervisor/slot_update.hpp"

#include <algorithm>
#include <cmath>

#include "control/closed_loop.hpp"
#include "control/model_rows.hpp"
#include "estimation/estimator.hpp"
#include "estimation/poles.hpp"

namespace farrier::supervisor {
namespace {

using signals::UpdateVerdict;

// Entries of a normalised model smaller than this have the uncertainty of one of this size.
constexpr double kSmallestEntry = 0.05;
// The valve's gain is taken for at most this share larger than its estimate.
constexpr double kLargestGainError = 2.0;

// A joint whose force is not what its model predicts oscillates as a rule, and shall not wait for a perfect estimate.
constexpr double kMisfitLeniency = 0.5;

bool is_refusal(UpdateVerdict verdict) noexcept { return verdict >= UpdateVerdict::kDesignRefused; }

}  // namespace

SlotUpdate::SlotUpdate(const robot::Joint& joint, const robot::UpdateLogicParams& logic, double estimate_period_s,
                       int estimate_period_ticks, const control::Gains& first)
    : rule_(joint.design),
      normalisation_(joint.normalisation),
      form_(joint.form),
      logic_(logic),
      period_s_(estimate_period_s / estimate_period_ticks),
      estimate_period_s_(estimate_period_s),
      estimate_period_ticks_(estimate_period_ticks),
      gains_(first),
      designed_poles_(poles_of(first.model)) {}

SlotUpdate::PoleSet SlotUpdate::poles_of(const control::DiscreteModel& model) const noexcept {
  if (form_ == control::Form::kFullState) {
    return estimation::poles<3>(model.a);
  }
  const Eigen::Matrix2d loop = model.a.bottomRightCorner<2, 2>();
  const estimation::Poles<2> z = estimation::poles<2>(loop);
  return {z[0], z[1], 0.0};
}

double SlotUpdate::distance(const PoleSet& a, const PoleSet& b) const noexcept {
  if (form_ == control::Form::kFullState) {
    return estimation::pole_distance<3>(a, b);
  }
  return estimation::pole_distance<2>({a[0], a[1]}, {b[0], b[1]});
}

void SlotUpdate::follow(const PoleSet& poles) noexcept {
  const double moved = still_ticks_ < 0 ? INFINITY : distance(poles, anchor_);
  if (moved <= logic_.pole_spread_max) {
    still_ticks_ += estimate_period_ticks_;
    spread_ = std::max(spread_, moved);
  } else {
    anchor_ = poles;
    still_ticks_ = 0;
    spread_ = 0;
  }
}

signals::JointUpdateDecision SlotUpdate::look(const signals::JointModelEstimate& estimate, Tick tick) noexcept {
  const control::DiscreteModel model = control::model_of_rows(estimate.a, estimate.b);
  signals::JointUpdateDecision decision;
  decision.joint = estimate.joint;
  decision.tick = tick;
  decision.phase = estimate.phase;
  decision.estimate_samples = estimate.samples;
  decision.validity = estimate.validity;
  decision.excitation = estimate.excitation;
  decision.model_a = estimate.a;
  decision.model_b = estimate.b;
  const UpdateVerdict verdict = judge(estimate, model, decision);
  decision.verdict = static_cast<std::uint8_t>(verdict);
  is_news_ = verdict == UpdateVerdict::kAccepted || (is_refusal(verdict) && verdict != last_refusal_);
  if (verdict == UpdateVerdict::kAccepted || is_refusal(verdict)) {
    last_refusal_ = verdict;
  }
  return decision;
}

UpdateVerdict SlotUpdate::judge(const signals::JointModelEstimate& estimate, const control::DiscreteModel& model,
                                signals::JointUpdateDecision& decision) noexcept {
  // Zero is not an estimate at all, and a design divides by the valve's gain.
  if (!(estimate.validity > 0.0) || !model.a.allFinite() || !model.b.allFinite() || !(model.b(2) > 0.0)) {
    still_ticks_ = -1;
    return UpdateVerdict::kNotValid;
  }
  const PoleSet poles = poles_of(model);
  follow(poles);
  decision.pole_distance = distance(poles, designed_poles_);
  decision.pole_spread = spread_;
  decision.converged_ticks = static_cast<std::uint32_t>(std::max(still_ticks_, 0));
  for (std::size_t i = 0; i < poles.size(); ++i) {
    decision.poles_re[i] = poles[i].real();
    decision.poles_im[i] = poles[i].imag();
    decision.designed_poles_re[i] = designed_poles_[i].real();
    decision.designed_poles_im[i] = designed_poles_[i].imag();
  }
  // Too high a valve gain in the design slows a loop, too low a one destabilises it: designs are for the upper end.
  const double gain_error = std::min(kLargestGainError, logic_.error_sigmas * estimate.b_error[2] / model.b(2));
  control::DiscreteModel cautious = model;
  cautious.b *= 1.0 + gain_error;
  const double gain_ratio = cautious.b(2) / gains_.model.b(2);
  if (decision.pole_distance <= logic_.pole_distance_min &&
      std::max(gain_ratio, 1.0 / gain_ratio) <= logic_.gain_ratio_min) {
    contradicted_s_ = 0;
    return UpdateVerdict::kNotDifferentEnough;
  }
  if (still_ticks_ < logic_.converged_ticks) {
    return UpdateVerdict::kNotConverged;
  }
  const bool misfit = (estimate.flags & static_cast<std::uint32_t>(estimation::EstimateFlag::kMisfit)) != 0;
  if (estimate.validity < (misfit ? kMisfitLeniency : 1.0) * logic_.validity_min) {
    return UpdateVerdict::kNotValid;
  }
  const UpdateVerdict verdict = redesign(cautious, model, decision);
  if (verdict == UpdateVerdict::kAccepted) {
    designed_poles_ = poles;
    still_ticks_ = -1;
    contradicted_s_ = 0;
  }
  return verdict;
}

UpdateVerdict SlotUpdate::redesign(const control::DiscreteModel& cautious, const control::DiscreteModel& model,
                                   signals::JointUpdateDecision& decision) noexcept {
  const auto designed = control::design(cautious, rule_, normalisation_, form_, gains_.delay_ticks, period_s_);
  design_status_ = designed ? control::DesignStatus::kSuccessful : designed.error();
  if (!designed) {
    return UpdateVerdict::kDesignRefused;
  }
  const control::Gains& gains = designed.value();
  // A loop that integrates backwards, or pushes away from its reference, is stable only by the model's mistake.
  if (!(gains.integral > 0.0) || gains.feed_forward < 0.0) {
    design_status_ = control::DesignStatus::kClosedLoopNotStable;
    return UpdateVerdict::kDesignRefused;
  }
  decision.estimated_radius = control::closed_loop_spectral_radius(model, gains, gains.delay_ticks);
  if (!(decision.estimated_radius < 1.0)) {
    return UpdateVerdict::kUnstableOnEstimate;
  }
  decision.stored_radius = control::closed_loop_spectral_radius(stored_towards(cautious), gains, gains.delay_ticks);
  if (!(decision.stored_radius < 1.0)) {
    contradicted_s_ += estimate_period_s_;
    return UpdateVerdict::kUnstableOnStoredModel;
  }
  gains_ = gains;
  return UpdateVerdict::kAccepted;
}

// The stored model, every entry moved towards the estimate by at most its uncertainty.
control::DiscreteModel SlotUpdate::stored_towards(const control::DiscreteModel& model) const noexcept {
  const double uncertainty = logic_.model_uncertainty + logic_.uncertainty_growth_1_s * contradicted_s_;
  const auto moved = [&](double stored, double estimated) {
    const double reach = uncertainty * std::max(std::abs(stored), kSmallestEntry);
    return stored + std::clamp(estimated - stored, -reach, reach);
  };
  const control::DiscreteModel stored = control::normalise(gains_.model, normalisation_);
  const control::DiscreteModel estimated = control::normalise(model, normalisation_);
  const Eigen::Vector3d scale(normalisation_.position, normalisation_.velocity, normalisation_.force);
  const control::DiscreteModel between{stored.a.binaryExpr(estimated.a, moved), stored.b.binaryExpr(estimated.b, moved)};
  return {scale.asDiagonal() * between.a * scale.cwiseInverse().asDiagonal(),
          scale.cwiseProduct(between.b) / normalisation_.current_A};
}

}  // namespace farrier::supervisor
