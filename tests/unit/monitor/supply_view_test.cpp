#include "monitor/supply_view.hpp"

#include <gtest/gtest.h>

#include "feed.hpp"

namespace farrier::monitor {
namespace supply_view_test {

using testing::Feed;

TEST(SupplyView, IsShownUntilTheSupplyFallsSilent) {
  Feed feed;
  EXPECT_FALSE(feed.frame().supply);
  signals::SupplyState state;
  for (const Tick tick : {10, 20, 30, 40}) {
    state.tick = tick;
    feed.take(state);
  }
  signals::SupplyTruth truth;
  truth.tick = 40;
  feed.take(truth);
  const SupplyFrame supply = feed.frame().supply.value();
  ASSERT_EQ(supply.states.size(), 2u) << "fifty a second";
  EXPECT_EQ(supply.states[1].tick, 30);
  EXPECT_EQ(supply.newest.tick, 40);
  EXPECT_EQ(supply.newest_truth.value().tick, 40);
  EXPECT_TRUE(feed.frame().supply.value().states.empty()) << "they were in the frame before";
  feed.pass(1.1 * kSilent_s);
  EXPECT_FALSE(feed.frame().supply);
}

}  // namespace supply_view_test
}  // namespace farrier::monitor
