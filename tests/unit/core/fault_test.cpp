#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

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

TEST(FaultSet, TakesTheMostCarefulOutput) {
  FaultSet faults;
  EXPECT_EQ(faults.output(), SafeOutput::kTracking);
  faults.set(Fault::kValveSaturated);
  EXPECT_EQ(faults.output(), SafeOutput::kTracking);
  faults.set(Fault::kCommandStale);
  EXPECT_EQ(faults.output(), SafeOutput::kDamping);
  faults.set(Fault::kForceLost);
  EXPECT_EQ(faults.output(), SafeOutput::kPositionDamping);
  faults.set(Fault::kNoGains);
  EXPECT_EQ(faults.output(), SafeOutput::kNull);
}

TEST(FaultSet, HasFailedFromAnErrorOn) {
  for (const FaultInfo& info : kFaults) {
    FaultSet faults;
    faults.set(info.fault);
    EXPECT_EQ(faults.failed(), info.severity >= FaultSeverity::kError) << info.name;
    EXPECT_EQ(faults.output(), info.output) << info.name;
  }
}

TEST(SafetyTable, NamesEveryFaultDifferently) {
  std::set<std::string> names;
  for (const FaultInfo& info : kFaults) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name << " twice";
    EXPECT_STREQ(to_string(info.fault), info.name);
    EXPECT_EQ(&info_of(info.fault), &info);
  }
}

TEST(SafetyTable, LetsAnOperatorKnowOfEveryLatchedFault) {
  for (const FaultInfo& info : kFaults) {
    EXPECT_EQ(info.latched(), info.severity == FaultSeverity::kCritical) << info.name;
    EXPECT_TRUE(info.event.reported || info.severity == FaultSeverity::kInfo) << info.name;
  }
}

TEST(SafetyTable, PrintsALineForEachFaultTheMostCarefulFirst) {
  const std::string table = safety_table_markdown();
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(table, '\n')), kFaults.size() + 2);
  EXPECT_LT(table.find("`disarmed`"), table.find("`force lost`"));
  EXPECT_LT(table.find("`force lost`"), table.find("`command stale`"));
  EXPECT_LT(table.find("`command stale`"), table.find("`gains refused`"));
}

TEST(FaultSet, SaysSoWhenABitHasNoName) { EXPECT_EQ(to_string(FaultSet(1u << 31)), "unknown fault"); }

}  // namespace fault_test
}  // namespace farrier
