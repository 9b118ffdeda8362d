#include "bus_ros/graph.hpp"

#include <gtest/gtest.h>

namespace farrier::bus_ros {
namespace graph_test {

// A message with gids of 16 bytes ends nodes of Humble.
TEST(ActingGraph, IsThatOfTheNodesThatAreThereAndNoneAmongBothKinds) {
  EXPECT_EQ(acting_graph(Graph::kAuto, {}), Graph::kNone);
  EXPECT_EQ(acting_graph(Graph::kAuto, {.with_hash = 2, .without_hash = 0}), Graph::kJazzy);
  EXPECT_EQ(acting_graph(Graph::kAuto, {.with_hash = 0, .without_hash = 2}), Graph::kHumble);
  EXPECT_EQ(acting_graph(Graph::kAuto, {.with_hash = 2, .without_hash = 2}), Graph::kNone);
}

TEST(ActingGraph, AFormThatIsAskedForIsKept) {
  for (const Graph form : {Graph::kHumble, Graph::kJazzy, Graph::kNone}) {
    EXPECT_EQ(acting_graph(form, {.with_hash = 1, .without_hash = 1}), form);
  }
}

}  // namespace graph_test
}  // namespace farrier::bus_ros
