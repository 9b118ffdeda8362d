#include <gtest/gtest.h>

#include "core/fault.hpp"

namespace farrier {
namespace fault_test {

TEST(FaultSet, StartsEmpty) {
  const FaultSet faults;
  EXPECT_FALSE(faults.any());
  EXPECT_EQ(faults.bits(), 0u);
  EXPECT_EQ(to_string(faults), "");
}

TEST(FaultSet, SetsAndClearsOneFaultWithoutTouchingTheOthers) {
  FaultSet faults;
  faults.set(Fault::kTripped);
  faults.set(Fault::kNoGains);
  faults.set(Fault::kTripped, false);
  EXPECT_FALSE(faults.has(Fault::kTripped));
  EXPECT_TRUE(faults.has(Fault::kNoGains));
}

TEST(FaultSet, SurvivesTheWireAsItsBits) {
  FaultSet faults;
  faults.set(Fault::kSensorsStale);
  faults.set(Fault::kValveSaturated);
  EXPECT_EQ(FaultSet(faults.bits()), faults);
}

TEST(FaultSet, ReadsInOrderOfPrecedence) {
  FaultSet faults;
  faults.set(Fault::kCommandStale);
  faults.set(Fault::kDisarmed);
  EXPECT_EQ(to_string(faults), "disarmed, command stale");
}

TEST(FaultSet, NamesEveryFaultDifferently) {
  std::string all;
  for (std::uint32_t bit = 1; bit <= static_cast<std::uint32_t>(Fault::kActuatorSilent); bit <<= 1) {
    const std::string name = to_string(static_cast<Fault>(bit));
    EXPECT_NE(name, "unknown fault");
    EXPECT_EQ(all.find(name + ";"), std::string::npos) << name << " twice";
    all += name + ";";
  }
}

TEST(FaultSet, SaysSoWhenABitHasNoName) { EXPECT_EQ(to_string(FaultSet(1u << 31)), "unknown fault"); }

}  // namespace fault_test
}  // namespace farrier
