// Decisions of a slot that are worth reporting, and their cost.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/noise.hpp"
#include "estimates.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::supervisor {
namespace slot_news_test {

using namespace testing;
using signals::JointModelEstimate;
using signals::UpdateVerdict;

TEST(SlotUpdate, IsNewsOncePerReasonOfARefusal) {
  SlotUpdate slot = slot_for(cart(20.0), credulous());
  int news = 0;
  for (int look = 0; look < 100; ++look) {
    show(slot, estimate_of(unstabilisable()), look);
    news += slot.is_news() ? 1 : 0;
  }
  EXPECT_EQ(news, 1);
}

TEST(SlotUpdate, IsNewsAgainAfterSomethingElseWasAccepted) {
  SlotUpdate slot = slot_for(cart(20.0), credulous());
  insist(slot, estimate_of(unstabilisable()), 10);
  const auto accepted = insist(slot, estimate_of(model_of(cart(50.0))), 10);
  ASSERT_EQ(verdict_of(accepted.back()), UpdateVerdict::kAccepted);
  EXPECT_TRUE(slot.is_news());
  int news = 0;
  for (int look = 0; look < 10; ++look) {
    show(slot, estimate_of(unstabilisable()), look);
    news += slot.is_news() ? 1 : 0;
  }
  EXPECT_EQ(news, 1);
}

TEST(SlotUpdate, LooksWithoutAllocationEvenWhenItRedesigns) {
  SlotUpdate slot = slot_for(cart(20.0), credulous());
  const JointModelEstimate heavy = estimate_of(model_of(cart(50.0))), light = estimate_of(model_of(cart(0.5)));
  const JointModelEstimate refused = estimate_of(unstabilisable());
  int accepted = 0;
  const test::AllocationGuard guard;
  for (int look = 0; look < 60; ++look) {
    const JointModelEstimate& estimate = look < 20 ? heavy : look < 40 ? light : refused;
    accepted += show(slot, estimate, look).verdict == UpdateVerdict::kAccepted ? 1 : 0;
  }
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_GE(accepted, 1);
}

TEST(SlotUpdate, OnlyEverHasGainsThatAreStableOnTheirModel) {
  SlotUpdate slot = slot_for(cart(20.0), credulous());
  const NoiseStream noise(3, "slot", "model");
  int accepted = 0;
  for (int look = 0; look < 3000; ++look) {
    // A model that stays the same for long enough, and is then quite another one.
    control::DiscreteModel model = model_of(cart(20.0));
    for (int i = 0; i < 9; ++i) {
      model.a(i) *= 1.0 + 2.0 * noise.normal(look / 5 * 16 + i);
    }
    model.b *= std::pow(10.0, noise.normal(look / 5 * 16 + 10));
    if (look % 57 == 0) {
      model.a(look % 9) = look % 2 == 0 ? std::numeric_limits<double>::max() : std::nan("");
    }
    JointModelEstimate estimate = estimate_of(model);
    estimate.b_error[2] = look % 11 == 0 ? std::numeric_limits<double>::infinity() : estimate.b_error[2];
    const auto decision = show(slot, estimate, look);
    accepted += verdict_of(decision) == UpdateVerdict::kAccepted ? 1 : 0;
    const control::Gains& gains = slot.gains();
    ASSERT_LT(control::closed_loop_spectral_radius(gains.model, gains, gains.delay_ticks), 1.0) << look;
    ASSERT_TRUE(std::isfinite(gains.force) && std::isfinite(gains.feed_forward)) << look;
  }
  EXPECT_GT(accepted, 0) << "nothing was tried";
}

}  // namespace slot_news_test
}  // namespace farrier::supervisor
