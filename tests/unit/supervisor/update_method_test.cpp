// The update logics (a), (b) and (c) of the thesis, in a slot; (d) is what supervisor_slot_update_test.cpp is about.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/noise.hpp"
#include "estimates.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::supervisor {
namespace update_method_test {

using namespace testing;
using robot::UpdateMethod;
using signals::JointModelEstimate;
using signals::JointUpdateDecision;
using signals::UpdateVerdict;

constexpr UpdateMethod kMethods[] = {UpdateMethod::kLimits, UpdateMethod::kSmallError, UpdateMethod::kWhiteError,
                                     UpdateMethod::kDistinctPoles};
constexpr double kHeavy_kg = 50.0;
constexpr int kLong = 100;  // looks: a second
const double kNaN = std::numeric_limits<double>::quiet_NaN();

robot::UpdateLogicParams by(UpdateMethod method) {
  robot::UpdateLogicParams logic = credulous();
  logic.method = method;
  return logic;
}

/// Predicts as well as its sensors let it, with white errors.
JointModelEstimate good(double mass_kg = kHeavy_kg) {
  JointModelEstimate estimate = estimate_of(model_of(cart(mass_kg)));
  estimate.prediction_error = 1.0;
  estimate.whiteness = 0.5;
  return estimate;
}

/// Looks that wait before one that is accepted, by any method.
std::size_t waited() {
  return static_cast<std::size_t>(rig().update_logic.converged_ticks / rig().estimate_period_ticks);
}

TEST(UpdateMethods, AcceptTheSameGainsOfAGoodEstimateAfterTheSameWait) {
  for (const UpdateMethod method : kMethods) {
    SlotUpdate slot = slot_for(cart(20.0), by(method));
    const auto decisions = insist(slot, good(), kLong);
    ASSERT_EQ(verdict_of(decisions.back()), UpdateVerdict::kAccepted) << robot::to_string(method);
    EXPECT_EQ(decisions.size(), waited() + 1) << robot::to_string(method);
    EXPECT_EQ(slot.gains().force, gains_for(cart(kHeavy_kg)).force) << robot::to_string(method);
  }
}

// The argument of the thesis against (a) to (c), and for (d).
TEST(UpdateMethods, GoOnDesigningForTheSameEstimateUnlessTheyAskWhetherItIsDifferent) {
  for (const UpdateMethod method : kMethods) {
    SlotUpdate slot = slot_for(cart(20.0), by(method));
    int accepted = 0;
    for (int look = 0; look < kLong; ++look) {
      accepted += verdict_of(show(slot, good(), look)) == UpdateVerdict::kAccepted ? 1 : 0;
    }
    const int always = kLong - static_cast<int>(waited());
    const auto designs = static_cast<int>(slot.designs());
    EXPECT_EQ(accepted, method == UpdateMethod::kDistinctPoles ? 1 : always) << robot::to_string(method);
    EXPECT_EQ(designs, method == UpdateMethod::kLimits ? kLong : accepted) << robot::to_string(method);
  }
}

TEST(UpdateMethods, ByErrorWaitUntilThePredictionsAreGoodEnough) {
  for (const UpdateMethod method : {UpdateMethod::kSmallError, UpdateMethod::kWhiteError}) {
    JointModelEstimate estimate = good();
    for (const double error : {1.01 * by(method).prediction_error_max, 1e300, kNaN}) {
      estimate.prediction_error = error;
      SlotUpdate slot = slot_for(cart(20.0), by(method));
      const auto decisions = insist(slot, estimate, kLong);
      EXPECT_EQ(verdict_of(decisions.back()), UpdateVerdict::kErrorTooLarge) << error;
      EXPECT_EQ(slot.designs(), 0u) << "nothing is computed for it";
      EXPECT_FALSE(slot.is_news());
    }
  }
}

TEST(UpdateMethods, ByWhitenessWaitUntilNothingIsLeftInTheErrors) {
  JointModelEstimate coloured = good();
  for (const double whiteness : {0.0, 0.99 * by(UpdateMethod::kWhiteError).whiteness_min, kNaN}) {
    coloured.whiteness = whiteness;
    SlotUpdate white = slot_for(cart(20.0), by(UpdateMethod::kWhiteError));
    EXPECT_EQ(verdict_of(insist(white, coloured, kLong).back()), UpdateVerdict::kErrorNotWhite) << whiteness;
    EXPECT_EQ(white.designs(), 0u);
    SlotUpdate small = slot_for(cart(20.0), by(UpdateMethod::kSmallError));
    EXPECT_EQ(verdict_of(insist(small, coloured, kLong).back()), UpdateVerdict::kAccepted) << "(b) does not ask";
  }
}

TEST(UpdateMethods, ByErrorBeginToWaitAgainAfterABadOne) {
  SlotUpdate slot = slot_for(cart(20.0), by(UpdateMethod::kSmallError));
  JointModelEstimate bad = good();
  bad.prediction_error = 1e6;
  for (int look = 0; look < kLong; ++look) {
    const bool often_enough = look % static_cast<int>(waited() + 1) == 0;
    ASSERT_NE(verdict_of(show(slot, often_enough ? bad : good(), look)), UpdateVerdict::kAccepted) << look;
  }
}

TEST(UpdateMethods, ByLimitsRefuseGainsBeyondEachBoundByName) {
  const control::Gains fresh = gains_for(cart(kHeavy_kg));
  const double state = Eigen::Vector3d(fresh.position, fresh.velocity, fresh.force).norm();
  const auto verdict_with = [&](auto change) {
    robot::UpdateLogicParams logic = by(UpdateMethod::kLimits);
    change(logic);
    SlotUpdate slot = slot_for(cart(20.0), logic);
    const auto decisions = insist(slot, good(), kLong);
    return verdict_of(decisions.back());
  };
  EXPECT_EQ(verdict_with([&](auto& l) { l.state_gain_max = 0.99 * state; }), UpdateVerdict::kGainsTooLarge);
  EXPECT_EQ(verdict_with([&](auto& l) { l.integral_gain_max = 0.99 * fresh.integral; }),
            UpdateVerdict::kGainsTooLarge);
  EXPECT_EQ(verdict_with([&](auto& l) { l.feed_forward_max = 0.99 * fresh.feed_forward; }),
            UpdateVerdict::kGainsTooLarge);
  EXPECT_EQ(verdict_with([&](auto& l) {
              l.state_gain_max = 1.01 * state;
              l.integral_gain_max = 1.01 * fresh.integral;
              l.feed_forward_max = 1.01 * fresh.feed_forward;
            }),
            UpdateVerdict::kAccepted);
}

TEST(UpdateMethods, ByLimitsTellOfGainsBeyondTheirBoundsOnce) {
  robot::UpdateLogicParams logic = by(UpdateMethod::kLimits);
  logic.state_gain_max = 0.0;
  SlotUpdate slot = slot_for(cart(20.0), logic);
  int news = 0;
  for (int look = 0; look < kLong; ++look) {
    show(slot, good(), look);
    news += slot.is_news() ? 1 : 0;
  }
  EXPECT_EQ(news, 1);
}

TEST(UpdateMethods, ByLimitsWaitWhileGainsChangeFasterThanEachRate) {
  const auto accepted_with = [&](auto change) {
    robot::UpdateLogicParams logic = by(UpdateMethod::kLimits);
    logic.state_gain_rate_max_1_s = logic.integral_gain_rate_max_1_s = logic.feed_forward_rate_max_1_s = 1e6;
    change(logic);
    SlotUpdate slot = slot_for(cart(20.0), logic);
    int accepted = 0;
    for (int look = 0; look < kLong; ++look) {
      const UpdateVerdict verdict = verdict_of(show(slot, good(look % 2 == 0 ? 45.0 : 50.0), look));
      EXPECT_TRUE(verdict == UpdateVerdict::kAccepted || verdict == UpdateVerdict::kGainsChangeFast);
      accepted += verdict == UpdateVerdict::kAccepted ? 1 : 0;
    }
    return accepted;
  };
  EXPECT_GT(accepted_with([](auto&) {}), 0);
  EXPECT_EQ(accepted_with([](auto& l) { l.state_gain_rate_max_1_s = 1e-3; }), 0);
  EXPECT_EQ(accepted_with([](auto& l) { l.integral_gain_rate_max_1_s = 1e-3; }), 0);
  EXPECT_EQ(accepted_with([](auto& l) { l.feed_forward_rate_max_1_s = 1e-3; }), 0);
}

TEST(UpdateMethods, ByLimitsBeginToWaitAgainAfterADesignThatWasRefused) {
  SlotUpdate slot = slot_for(cart(20.0), by(UpdateMethod::kLimits));
  for (int look = 0; look < kLong; ++look) {
    const bool often_enough = look % static_cast<int>(waited() + 1) == 0;
    const JointModelEstimate estimate = often_enough ? estimate_of(unstabilisable()) : good();
    ASSERT_NE(verdict_of(show(slot, estimate, look)), UpdateVerdict::kAccepted) << look;
  }
}

// These are asked of a design of every method.
TEST(UpdateMethods, HaveTheSafetyOfNewGainsInCommon) {
  for (const UpdateMethod method : kMethods) {
    SCOPED_TRACE(robot::to_string(method));
    SlotUpdate refusing = slot_for(cart(20.0), by(method));
    JointModelEstimate estimate = good();
    estimate.a = estimate_of(unstabilisable()).a;
    estimate.b = estimate_of(unstabilisable()).b;
    EXPECT_EQ(verdict_of(insist(refusing, estimate, kLong).back()), UpdateVerdict::kDesignRefused);
    robot::UpdateLogicParams stubborn = by(method);
    stubborn.model_uncertainty = 0.0;
    stubborn.uncertainty_growth_1_s = 0.0;
    SlotUpdate guarded = slot_for(cart(kHeavy_kg), stubborn);
    EXPECT_EQ(verdict_of(insist(guarded, good(0.5), kLong).back()), UpdateVerdict::kUnstableOnStoredModel);
    SlotUpdate unsure = slot_for(cart(20.0), by(method));
    estimate = good();
    estimate.validity = 0.9 * rig().update_logic.validity_min;
    EXPECT_EQ(verdict_of(insist(unsure, estimate, kLong).back()), UpdateVerdict::kNotValid);
  }
}

TEST(UpdateMethods, LookWithoutAllocationAtWhateverComesAndKeepStableGains) {
  const NoiseStream noise(5, "method", "estimate");
  for (const UpdateMethod method : kMethods) {
    SlotUpdate slot = slot_for(cart(20.0), by(method));
    int accepted = 0;
    const test::AllocationGuard guard;
    for (int look = 0; look < 600; ++look) {
      JointModelEstimate estimate = good(0.5 + 50.0 * noise.uniform(static_cast<std::uint64_t>(look / 20)));
      if (look % 7 == 0) {
        estimate.prediction_error = estimate.whiteness = kNaN;
      } else if (look % 11 == 0) {
        estimate.a[4] = INFINITY;
      } else if (look % 13 == 0) {
        estimate.validity = kNaN;
      }
      accepted += verdict_of(show(slot, estimate, look)) == UpdateVerdict::kAccepted ? 1 : 0;
      ASSERT_LT(control::closed_loop_spectral_radius(slot.gains().model, slot.gains(), kNoDelay), 1.0);
    }
    EXPECT_EQ(guard.allocations(), 0u);
    EXPECT_GT(accepted, 0) << robot::to_string(method);
  }
}

}  // namespace update_method_test
}  // namespace farrier::supervisor
