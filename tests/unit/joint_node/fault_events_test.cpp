#include <gtest/gtest.h>

#include "joint_node/fault_events.hpp"

namespace farrier::joint_node {
namespace fault_events_test {

FaultSet of(std::initializer_list<Fault> faults) {
  FaultSet set;
  for (const Fault fault : faults) {
    set.set(fault);
  }
  return set;
}

TEST(FaultEvents, SayNothingWhileAJointIsWell) {
  FaultEvents events;
  for (Tick tick = 0; tick < 10; ++tick) {
    EXPECT_EQ(events.update(tick, {}), std::nullopt);
  }
}

TEST(FaultEvents, TellAChangeOnceWithItsCause) {
  FaultEvents events;
  EXPECT_EQ(events.update(0, of({Fault::kSensorsStale})), "sensors stale");
  EXPECT_EQ(events.update(1, of({Fault::kSensorsStale})), std::nullopt);
  EXPECT_EQ(events.update(2, of({Fault::kSensorsStale, Fault::kCommandStale})), "sensors stale, command stale");
  EXPECT_EQ(events.update(3, {}), "no fault");
  EXPECT_EQ(events.update(4, {}), std::nullopt);
}

TEST(FaultEvents, TellAReferenceThatFlickersAtItsLimitOnce) {
  FaultEvents events;
  EXPECT_EQ(events.update(0, of({Fault::kReferenceClamped})), "reference clamped");
  Tick tick = 1;
  for (; tick < 500; ++tick) {
    EXPECT_EQ(events.update(tick, tick % 50 == 0 ? of({Fault::kReferenceClamped}) : FaultSet{}), std::nullopt);
  }
  int told = 0;
  for (; tick < 1000; ++tick) {
    told += events.update(tick, {}) == "no fault" ? 1 : 0;
  }
  EXPECT_EQ(told, 1);
}

TEST(FaultEvents, CountASaturatedValveAsPartOfControl) {
  FaultEvents events;
  EXPECT_EQ(events.update(0, of({Fault::kValveSaturated})), std::nullopt);
}

}  // namespace fault_events_test
}  // namespace farrier::joint_node
