#include "supervisor/slot_update.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "estimation/estimator.hpp"
#include "estimation/poles.hpp"
#include "estimates.hpp"

namespace farrier::supervisor {
namespace slot_update_test {

using namespace testing;
using signals::JointModelEstimate;
using signals::JointUpdateDecision;
using signals::UpdateVerdict;

constexpr double kLight_kg = 0.5, kHeavy_kg = 50.0;  // of Fig. 7.6
constexpr int kLong = 1000;                          // looks: ten seconds

TEST(SlotUpdate, LeavesGainsAloneThatAreDesignedForWhatIsEstimated) {
  SlotUpdate slot = slot_for(cart(10.0));
  const control::Gains before = slot.gains();
  for (const JointUpdateDecision& decision : insist(slot, estimate_of(model_of(cart(10.0))), kLong)) {
    ASSERT_EQ(verdict_of(decision), UpdateVerdict::kNotDifferentEnough);
    ASSERT_EQ(decision.pole_distance, 0.0);
  }
  EXPECT_EQ(slot.gains().force, before.force);
  EXPECT_FALSE(slot.is_news());
}

TEST(SlotUpdate, AcceptsAConvergedEstimateWithTheGainsAnLqrForItHas) {
  const control::DiscreteModel model = model_of(cart(kHeavy_kg));
  SlotUpdate slot = slot_for(cart(20.0), credulous());
  const auto decisions = insist(slot, estimate_of(model), kLong);
  ASSERT_EQ(verdict_of(decisions.back()), UpdateVerdict::kAccepted);
  EXPECT_TRUE(slot.is_news());
  const robot::Joint& joint = rig().joints[0];
  const control::Gains fresh =
      control::design_lqr(model, joint.design.weights, joint.normalisation, joint.form, kNoDelay).value();
  const control::Gains& gains = slot.gains();
  EXPECT_EQ(gains.position, fresh.position);
  EXPECT_EQ(gains.velocity, fresh.velocity);
  EXPECT_EQ(gains.force, fresh.force);
  EXPECT_EQ(gains.integral, fresh.integral);
  EXPECT_EQ(gains.feed_forward, fresh.feed_forward);
  EXPECT_EQ(gains.model.a, model.a);
  EXPECT_EQ(gains.spectral_radius, fresh.spectral_radius);
  EXPECT_EQ(show(slot, estimate_of(model), 0).verdict, UpdateVerdict::kNotDifferentEnough)
      << "it is what the gains are designed for now";
}

TEST(SlotUpdate, WaitsUntilThePolesHaveConverged) {
  SlotUpdate slot = slot_for(cart(20.0), credulous());
  const auto decisions = insist(slot, estimate_of(model_of(cart(kHeavy_kg))), kLong);
  const auto waited = static_cast<std::size_t>(rig().update_logic.converged_ticks / rig().estimate_period_ticks);
  ASSERT_EQ(decisions.size(), waited + 1);
  for (std::size_t i = 0; i < waited; ++i) {
    EXPECT_EQ(verdict_of(decisions[i]), UpdateVerdict::kNotConverged);
    EXPECT_EQ(decisions[i].converged_ticks, i * static_cast<std::size_t>(rig().estimate_period_ticks));
  }
}

TEST(SlotUpdate, NeverAcceptsPolesThatKeepMoving) {
  SlotUpdate slot = slot_for(cart(20.0), credulous());
  for (int look = 0; look < kLong; ++look) {
    const double mass = look % 2 == 0 ? kLight_kg : kHeavy_kg;
    const JointUpdateDecision decision = show(slot, estimate_of(model_of(cart(mass))), look);
    ASSERT_EQ(verdict_of(decision), UpdateVerdict::kNotConverged) << look;
    ASSERT_EQ(decision.converged_ticks, 0u);
  }
}

TEST(SlotUpdate, DoesNotActOnAnEstimateThatIsUnsure) {
  for (const double validity : {0.0, std::numeric_limits<double>::quiet_NaN(), 0.9 * rig().update_logic.validity_min}) {
    SlotUpdate slot = slot_for(cart(20.0), credulous());
    JointModelEstimate estimate = estimate_of(model_of(cart(kHeavy_kg)));
    estimate.validity = validity;
    const auto decisions = insist(slot, estimate, kLong);
    EXPECT_EQ(verdict_of(decisions.back()), UpdateVerdict::kNotValid) << validity;
    EXPECT_EQ(decisions.size(), static_cast<std::size_t>(kLong));
    EXPECT_FALSE(slot.is_news()) << "that happens all the time";
  }
}

TEST(SlotUpdate, ActsOnALessSureEstimateOfAJointThatOscillates) {
  JointModelEstimate estimate = estimate_of(model_of(cart(kHeavy_kg)));
  estimate.validity = 0.6 * rig().update_logic.validity_min;
  SlotUpdate calm = slot_for(cart(20.0), credulous());
  EXPECT_EQ(verdict_of(insist(calm, estimate, kLong).back()), UpdateVerdict::kNotValid);
  estimate.flags = static_cast<std::uint32_t>(estimation::EstimateFlag::kMisfit);
  SlotUpdate oscillating = slot_for(cart(20.0), credulous());
  EXPECT_EQ(verdict_of(insist(oscillating, estimate, kLong).back()), UpdateVerdict::kAccepted);
}

TEST(SlotUpdate, DoesNotActOnAModelThatIsNotFiniteOrHasNoForwardValve) {
  const auto verdict_when = [](auto change) {
    SlotUpdate slot = slot_for(cart(20.0), credulous());
    JointModelEstimate estimate = estimate_of(model_of(cart(kHeavy_kg)));
    change(estimate);
    return verdict_of(insist(slot, estimate, 100).back());
  };
  EXPECT_EQ(verdict_when([](auto& e) { e.b[2] = -e.b[2]; }), UpdateVerdict::kNotValid);
  EXPECT_EQ(verdict_when([](auto& e) { e.b[2] = 0.0; }), UpdateVerdict::kNotValid);
  EXPECT_EQ(verdict_when([](auto& e) { e.a[4] = std::nan(""); }), UpdateVerdict::kNotValid);
  EXPECT_EQ(verdict_when([](auto& e) { e.b[1] = INFINITY; }), UpdateVerdict::kNotValid);
  EXPECT_EQ(verdict_when([](auto& e) { e.validity = 0.9; }), UpdateVerdict::kAccepted) << "unchanged";
}

TEST(SlotUpdate, ComparesPolesAsSets) {
  // Real poles whose order by modulus swaps: 0.80 and 0.79 with the force slow, then the velocity.
  robot::Joint joint = rig().joints[0];
  joint.form = control::Form::kCompliant;
  control::DiscreteModel one = model_of(cart(20.0));
  one.a.bottomRightCorner<2, 2>() << 0.80, 0.0, 0.0, 0.79;
  control::DiscreteModel other = one;
  other.a.bottomRightCorner<2, 2>() << 0.79, 0.0, 0.0, 0.80;
  control::Gains gains = gains_for(cart(20.0));
  gains.model = one;
  SlotUpdate slot(joint, rig().update_logic, rig().period_s, 10, gains);
  EXPECT_NEAR(show(slot, estimate_of(other), 0).pole_distance, 0.0, 1e-12);
  control::DiscreteModel mirrored = one;
  mirrored.a.bottomRightCorner<2, 2>() << -0.80, 0.0, 0.0, -0.79;
  EXPECT_NEAR(show(slot, estimate_of(mirrored), 10).pole_distance, 1.59, 1e-12);
}

TEST(SlotUpdate, RedesignsForAValveGainThatHasChangedBetweenTheSamePoles) {
  for (const double factor : {1.5, 1.0 / 1.5}) {
    SlotUpdate slot = slot_for(cart(20.0), credulous());
    control::DiscreteModel model = model_of(cart(20.0));
    model.b *= factor;
    const auto decisions = insist(slot, estimate_of(model), kLong);
    EXPECT_EQ(verdict_of(decisions.back()), UpdateVerdict::kAccepted) << factor;
    EXPECT_EQ(decisions.back().pole_distance, 0.0);
  }
  SlotUpdate slot = slot_for(cart(20.0), credulous());
  control::DiscreteModel model = model_of(cart(20.0));
  model.b *= 1.1;
  EXPECT_EQ(verdict_of(insist(slot, estimate_of(model), kLong).back()), UpdateVerdict::kNotDifferentEnough);
}

// Too high a valve gain in the design slows a loop, too low a one destabilises it.
TEST(SlotUpdate, DesignsForTheUpperEndOfTheValveGain) {
  constexpr double kError = 0.1;
  robot::UpdateLogicParams logic = credulous();
  logic.error_sigmas = 2.0;
  SlotUpdate slot = slot_for(cart(20.0), logic);
  const control::DiscreteModel model = model_of(cart(kHeavy_kg));
  ASSERT_EQ(verdict_of(insist(slot, estimate_of(model, 0, signals::Phase::kSwing, kError), kLong).back()),
            UpdateVerdict::kAccepted);
  const double upper = 1.0 + logic.error_sigmas * kError;
  EXPECT_NEAR(slot.gains().model.b(2), upper * model.b(2), 1e-12 * model.b(2));
  const control::Gains sure = gains_for(cart(kHeavy_kg));
  EXPECT_LT(slot.gains().force, sure.force);
  EXPECT_LT(control::closed_loop_spectral_radius(model, slot.gains(), kNoDelay), 1.0) << "stable on the estimate too";
}

TEST(SlotUpdate, BelievesAnErrorOfTheValveGainUpToItsLimit) {
  for (const double error : {100.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    robot::UpdateLogicParams logic = credulous();
    logic.error_sigmas = 2.0;
    SlotUpdate slot = slot_for(cart(20.0), logic);
    const control::DiscreteModel model = model_of(cart(kHeavy_kg));
    const auto decisions = insist(slot, estimate_of(model, 0, signals::Phase::kSwing, error), kLong);
    constexpr double kLargestGainError = 2.0;
    if (verdict_of(decisions.back()) == UpdateVerdict::kAccepted) {
      EXPECT_NEAR(slot.gains().model.b(2), (1.0 + kLargestGainError) * model.b(2), 1e-9 * model.b(2)) << error;
    }
    EXPECT_TRUE(std::isfinite(slot.gains().force)) << error;
  }
}

TEST(SlotUpdate, RefusesADesignByName) {
  SlotUpdate slot = slot_for(cart(20.0), credulous());
  const auto decisions = insist(slot, estimate_of(unstabilisable()), 100);
  EXPECT_EQ(verdict_of(decisions.back()), UpdateVerdict::kDesignRefused);
  EXPECT_EQ(slot.design_status(), control::DesignStatus::kNotStabilisable) << control::to_string(slot.design_status());
}

TEST(SlotUpdate, DecidesOnTheEvidenceItGives) {
  SlotUpdate slot = slot_for(cart(20.0), credulous());
  const control::DiscreteModel model = model_of(cart(kHeavy_kg));
  const JointUpdateDecision accepted = insist(slot, estimate_of(model, 0, signals::Phase::kStance), kLong).back();
  const JointModelEstimate estimate = estimate_of(model);
  EXPECT_EQ(accepted.phase, signals::Phase::kStance);
  EXPECT_EQ(accepted.validity, estimate.validity);
  EXPECT_EQ(accepted.excitation, estimate.excitation);
  EXPECT_EQ(accepted.estimate_samples, estimate.samples);
  EXPECT_EQ(accepted.model_a, estimate.a);
  EXPECT_EQ(accepted.model_b, estimate.b);
  EXPECT_GT(accepted.pole_distance, rig().update_logic.pole_distance_min);
  EXPECT_EQ(accepted.pole_spread, 0.0);
  EXPECT_TRUE(accepted.estimated_radius > 0.0 && accepted.estimated_radius < 1.0);
  EXPECT_TRUE(accepted.stored_radius > 0.0 && accepted.stored_radius < 1.0);
  const auto designed_for = estimation::poles<3>(model_of(cart(20.0)).a);
  for (std::size_t i = 0; i < designed_for.size(); ++i) {
    EXPECT_EQ(accepted.designed_poles_re[i], designed_for[i].real());
    EXPECT_EQ(accepted.designed_poles_im[i], designed_for[i].imag());
  }
}

// Both ways round, and however far: what is true must win in the end, and soon.
TEST(SlotUpdate, AcceptsTheTruthAfterALoadChangesByAHundredfold) {
  for (const auto& [from_kg, to_kg] : {std::pair{kLight_kg, kHeavy_kg}, std::pair{kHeavy_kg, kLight_kg}}) {
    SlotUpdate slot = slot_for(cart(from_kg));
    const auto decisions = insist(slot, estimate_of(model_of(cart(to_kg))), kLong);
    ASSERT_EQ(verdict_of(decisions.back()), UpdateVerdict::kAccepted) << from_kg << " to " << to_kg;
    constexpr std::size_t kHalfASecond = 50;
    EXPECT_LE(decisions.size(), kHalfASecond) << from_kg << " to " << to_kg;
    EXPECT_EQ(slot.gains().force, gains_for(cart(to_kg)).force);
  }
}

TEST(SlotUpdate, RefusesWhatTheStoredModelForbidsUntilEvidencePersists) {
  robot::UpdateLogicParams stubborn = rig().update_logic;
  stubborn.model_uncertainty = 0.0;
  stubborn.uncertainty_growth_1_s = 0.0;
  int refused = 0;
  for (const auto& [from_kg, to_kg] : {std::pair{kLight_kg, kHeavy_kg}, std::pair{kHeavy_kg, kLight_kg}}) {
    SlotUpdate never = slot_for(cart(from_kg), stubborn);
    const JointUpdateDecision last = insist(never, estimate_of(model_of(cart(to_kg))), kLong).back();
    if (verdict_of(last) != UpdateVerdict::kUnstableOnStoredModel) {
      continue;
    }
    ++refused;
    EXPECT_GE(last.stored_radius, 1.0);
    EXPECT_LT(last.estimated_radius, 1.0);
    EXPECT_EQ(never.gains().force, gains_for(cart(from_kg)).force) << "the gains stay";
    robot::UpdateLogicParams growing = stubborn;
    growing.uncertainty_growth_1_s = rig().update_logic.uncertainty_growth_1_s;
    SlotUpdate later = slot_for(cart(from_kg), growing);
    const auto decisions = insist(later, estimate_of(model_of(cart(to_kg))), kLong);
    EXPECT_EQ(verdict_of(decisions.back()), UpdateVerdict::kAccepted);
    EXPECT_GT(decisions.size(), 4u) << "not at the first contradiction";
  }
  EXPECT_GT(refused, 0) << "no transition was forbidden";
}

}  // namespace slot_update_test
}  // namespace farrier::supervisor
