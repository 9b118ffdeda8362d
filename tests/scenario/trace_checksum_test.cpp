// The trace of a seed stays what it was, byte for byte. A change that means to change traces changes the numbers here,
// in a commit that does nothing else.

#include <cstdint>

#include "tests/scenario/scenario_run.hpp"

namespace farrier::scenario {
namespace trace_checksum_test {

constexpr Tick kRun = 2000;  // two strides: swing, stance and redesigns

struct Kept {
  const char* robot;
  gait::Pattern gait;
  std::uint64_t checksum;
};

void PrintTo(const Kept& kept, std::ostream* out) { *out << kept.robot; }

/// FNV-1a, 64 bits (Fowler, Noll, Vo 1991).
std::uint64_t checksum(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char byte : bytes) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  }
  return hash;
}

class Trace : public testing::TestWithParam<Kept> {};

TEST_P(Trace, OfASeedIsWhatItWas) {
  const Kept& kept = GetParam();
  robot::Overrides gait;
  gait.pattern = kept.gait;
  run::InprocRun settings;
  settings.ticks = kRun;
  settings.design = supervisor::Design::kAdaptive;
  const std::string trace = run(load(kept.robot, gait), settings).trace;
  ASSERT_GT(trace.size(), 100'000u);
  EXPECT_EQ(checksum(trace), kept.checksum);
}

INSTANTIATE_TEST_SUITE_P(OfEveryRobotAndGait, Trace,
                         testing::Values(Kept{"hyq", gait::Pattern::kTrot, 0x80b8f92b24c6416cu},
                                         Kept{"hyq", gait::Pattern::kStand, 0x9383bf6a5daa7583u},
                                         Kept{"fc1d", gait::Pattern::kTrot, 0xe0bbf5b6fc315450u},
                                         Kept{"fc1d", gait::Pattern::kStand, 0x763e25aa133b7ce9u},
                                         Kept{"hexapod", gait::Pattern::kTrot, 0xfe1b677f0ed3f37bu},
                                         Kept{"hexapod", gait::Pattern::kStand, 0x21a3d6d0e2e25b55u},
                                         Kept{"electric_leg", gait::Pattern::kTrot, 0xcf829127aede051du},
                                         Kept{"electric_leg", gait::Pattern::kStand, 0xfbdb8501fc114177u}),
                         [](const auto& kept) {
                           return std::string(kept.param.robot) +
                                  (kept.param.gait == gait::Pattern::kTrot ? "_trot" : "_stand");
                         });

}  // namespace trace_checksum_test
}  // namespace farrier::scenario
