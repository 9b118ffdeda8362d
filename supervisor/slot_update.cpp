#include "supervisor/slot_update.hpp"

#include <algorithm>
#include <cmath>

#include "control/design/closed_loop.hpp"
#include "control/design/filtered_loop.hpp"
#include "control/model/model_rows.hpp"
#include "control/design/switching.hpp"
#include "estimation/estimator.hpp"
#include "robot/joint_model.hpp"
#include "robot/sensor_path.hpp"

namespace farrier::supervisor {
namespace {

using signals::UpdateVerdict;

// Entries of a normalised model smaller than this have the uncertainty of one of this size.
constexpr double kSmallestEntry = 0.05;
// Pole distance used if the acting gains are unknown. Larger than any distance on the unit disk (at most 2).
constexpr double kUnknownDistance = 10.0;
// The valve's gain is assumed to exceed its estimate by at most this share.
constexpr double kLargestGainError = 2.0;

// A joint whose force its model does not predict usually oscillates, and must not wait for a perfect estimate.
constexpr double kMisfitLeniency = 0.5;

}  // namespace

SlotUpdate::SlotUpdate(const robot::Joint& joint, const robot::UpdateLogicParams& logic, double period_s,
                       int estimate_period_ticks, const control::Gains& first,
                       const std::vector<plant::LoadParams>& loads_to_hold, bool misfit_is_common)
    : rule_(joint.design),
      normalisation_(joint.normalisation),
      form_(joint.form),
      logic_(logic),
      filters_(robot::measurement_filters(joint, period_s)),
      period_s_(period_s),
      estimate_period_s_(estimate_period_ticks * period_s),
      method_(make_method(logic, joint.form, estimate_period_ticks, estimate_period_s_)),
      gains_(first),
      designed_poles_(poles_of(first.model, joint.form)),
      misfit_leniency_(misfit_is_common ? 1.0 : kMisfitLeniency) {
  if (!loads_to_hold.empty()) {
    law_.emplace(joint, period_s, first.delay_ticks);
  }
  for (const plant::LoadParams& load : loads_to_hold) {
    physics_to_hold_.push_back(robot::nominal_physics(joint, load));
  }
}

void SlotUpdate::adopt(const control::Gains& gains) noexcept {
  gains_ = gains;
  designed_poles_ = poles_of(gains.model, form_);
  doubted_ = false;
  contradicted_s_ = 0;
  std::visit([](auto& method) { method.restart(); }, method_);
}

signals::JointUpdateDecision SlotUpdate::look(const signals::JointModelEstimate& estimate, Tick tick,
                                              const SlotPair& pair) noexcept {
  const control::DiscreteModel model = control::model_of_rows(estimate.a, estimate.b);
  signals::JointUpdateDecision decision = record_of(estimate, tick);
  const UpdateVerdict verdict = judge(estimate, model, pair, decision);
  decision.verdict = verdict;
  news_.take(verdict);
  return decision;
}

UpdateVerdict SlotUpdate::judge(const signals::JointModelEstimate& estimate, const control::DiscreteModel& model,
                                const SlotPair& pair, signals::JointUpdateDecision& decision) noexcept {
  // Zero is not an estimate at all, and a design divides by the valve's gain.
  if (!(estimate.validity > 0.0) || !model.a.allFinite() || !model.b.allFinite() || !(model.b(2) > 0.0)) {
    std::visit([](auto& method) { method.restart(); }, method_);
    return UpdateVerdict::kNotValid;
  }
  const PoleSet poles = poles_of(model, form_);
  decision.pole_distance = doubted_ ? kUnknownDistance : distance(poles, designed_poles_, form_);
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
  const bool misfit = (estimate.flags & static_cast<std::uint32_t>(estimation::EstimateFlag::kMisfit)) != 0;
  const Evidence evidence{.prediction_error = estimate.prediction_error,
                          .whiteness = estimate.whiteness,
                          .valid = !(estimate.validity < (misfit ? misfit_leniency_ : 1.0) * logic_.validity_min),
                          .poles = poles,
                          .pole_distance = decision.pole_distance,
                          .gain_ratio = cautious.b(2) / gains_.model.b(2)};
  UpdateVerdict verdict = std::visit([&](auto& method) { return method.before_design(evidence); }, method_);
  decision.pole_spread = std::visit([](const auto& method) { return method.spread(); }, method_);
  decision.converged_ticks =
      static_cast<std::uint32_t>(std::max(std::visit([](const auto& m) { return m.held_ticks(); }, method_), 0));
  if (verdict == UpdateVerdict::kNotDifferentEnough) {
    contradicted_s_ = 0;
  }
  if (verdict != UpdateVerdict::kAccepted) {
    return verdict;
  }
  if (pair.dwelling) {
    return UpdateVerdict::kDwelling;
  }
  verdict = redesign(cautious, model, pair, decision);
  if (verdict == UpdateVerdict::kAccepted) {
    designed_poles_ = poles;
    doubted_ = false;
    contradicted_s_ = 0;
    std::visit([](auto& method) { method.accepted(); }, method_);
  }
  return verdict;
}

UpdateVerdict SlotUpdate::redesign(const control::DiscreteModel& cautious, const control::DiscreteModel& model,
                                   const SlotPair& pair, signals::JointUpdateDecision& decision) noexcept {
  ++designs_;
  control::SmallSpectrum poles;
  const auto designed = control::design(cautious, rule_, normalisation_, form_, gains_.delay_ticks, period_s_, &poles);
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
  const UpdateVerdict judged = std::visit([&](auto& method) { return method.after_design(gains); }, method_);
  if (judged != UpdateVerdict::kAccepted) {
    return judged;
  }
  decision.estimated_radius = control::closed_loop_spectral_radius(model, gains, gains.delay_ticks);
  if (!(decision.estimated_radius < 1.0)) {
    return UpdateVerdict::kUnstableOnEstimate;
  }
  const control::DiscreteModel stored = stored_towards(cautious);
  decision.stored_radius = control::closed_loop_spectral_radius(stored, gains, gains.delay_ticks);
  if (!(decision.stored_radius < 1.0) ||
      (!filters_.are_wires() && !control::filtered_loop_is_stable(stored, gains, gains.delay_ticks, filters_)) ||
      !std::ranges::all_of(physics_to_hold_, [&](const auto& physics) { return law_->settles(gains, physics); })) {
    contradicted_s_ += estimate_period_s_;
    return UpdateVerdict::kUnstableOnStoredModel;
  }
  const UpdateVerdict held = hold(gains, poles, pair, decision);
  if (held == UpdateVerdict::kAccepted) {
    gains_ = gains;
  }
  return held;
}

// Margins of the loop, and of the joint that changes between its two.
UpdateVerdict SlotUpdate::hold(const control::Gains& gains, const control::SmallSpectrum& poles, const SlotPair& pair,
                               signals::JointUpdateDecision& decision) const noexcept {
  const LoopMargins margins = margins_of(gains, period_s_, filters_, poles);
  decision.disk_margin = margins.disk;
  decision.delay_margin_s = margins.delay_s;
  if (!sufficient(margins, logic_)) {
    return UpdateVerdict::kMarginTooSmall;
  }
  const int dwell = pair.shortest_phase_ticks == control::kNoDwell ? 0 : dwell_ticks(gains, pair.other);
  decision.dwell_ticks = static_cast<std::uint32_t>(dwell);
  return dwell > pair.shortest_phase_ticks ? UpdateVerdict::kDwellTooLong : UpdateVerdict::kAccepted;
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
  const control::DiscreteModel between{stored.a.binaryExpr(estimated.a, moved),
                                       stored.b.binaryExpr(estimated.b, moved)};
  return {scale.asDiagonal() * between.a * scale.cwiseInverse().asDiagonal(),
          scale.cwiseProduct(between.b) / normalisation_.current_A};
}

}  // namespace farrier::supervisor
