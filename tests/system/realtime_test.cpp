// The real-time clock on a computer that may be no real-time one: what must hold there, too.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "farrier_command.hpp"

namespace farrier::test {
namespace realtime_test {

constexpr const char* kDuration = "3";
constexpr double kTicks = 3000;
constexpr double kTicksPerSecond = 1000;
constexpr double kReserve = 1.25;  // the rate of a computer that others use changes from run to run
constexpr double kJointsPerLeg = 3;
constexpr double kMayBeMissing = 0.2;  // best effort, on a computer that others use

/// Ticks a second at which this computer exchanges a run's samples over the slower vendor of `dds` and does nothing else.
/// Measured once, after a run that lacks samples.
double bare_rate(const std::string& dds) {
  static const nlohmann::json measured = [] {
    ScratchDirectory scratch;
    run_farrier({"bench", "--only", "lockstep", "--out", scratch.file("bench")});
    return read_json(scratch.file("bench/figures.json"));
  }();
  double slowest = INFINITY;
  for (const auto& entry : measured["figures"]) {
    const std::string name = entry["name"];
    const bool of_vendor = dds == "mixed" || name.find("." + dds + ".") != std::string::npos;
    if (of_vendor && name.ends_with(".bare_ticks_per_s")) {
      slowest = std::min(slowest, entry["value"].get<double>());
    }
  }
  return slowest;
}

class RealTimeTrot : public testing::TestWithParam<const char*> {
 protected:
  RealTimeTrot() {
    run_farrier({"trot", "--world", "bench", "--clock", "realtime", "--dds", GetParam(), "--nodes", "per-leg",
                 "--duration", kDuration, "--out", scratch_.file("out")},
                &output_);
    run_ = read_json(scratch_.file("out/figures.json"));
  }

  ScratchDirectory scratch_;
  std::string output_;
  nlohmann::json run_;
};

TEST_P(RealTimeTrot, EndsWithTheFiguresOfEveryProcess) {
  ASSERT_FALSE(run_.is_discarded()) << output_;
  EXPECT_EQ(run_["run"]["processes"].size(), 9u) << "those of the robot and the launcher";
  for (const auto& process : run_["run"]["processes"]) {
    const std::string name = process["name"];
    const std::string packets = "trot.packets." + name + ".";
    EXPECT_TRUE(std::ranges::any_of(run_["figures"],
                                    [&](const auto& entry) {
                                      return entry["name"].template get<std::string>().starts_with(packets) &&
                                             entry["value"].template get<double>() > 0.0;
                                    }))
        << name << " has no figures of what it sent or received";
  }
  double fewest = INFINITY;
  for (const char* leg : {"lf", "rf", "lh", "rh"}) {
    const std::string received = std::string("trot.packets.joint_node_") + leg + ".joint_sensors.received";
    fewest = std::min(fewest, figure(run_, received));
    EXPECT_GE(figure(run_, received), 1.0) << received;
    EXPECT_LE(figure(run_, received), kJointsPerLeg * kTicks) << received;
  }
  const bool enough = fewest >= (1.0 - kMayBeMissing) * kJointsPerLeg * kTicks;
  EXPECT_NEAR(figure(run_, "trot.ticks"), kTicks, 1.0);
  EXPECT_GT(figure(run_, "trot.latency_p50_us"), 0.0);
  EXPECT_LE(figure(run_, "trot.latency_p50_us"), figure(run_, "trot.latency_p99_us"));
  // Where the bare exchange itself hardly reaches the joints' rate, samples are lost whatever the nodes do.
  if (!enough) {
    ASSERT_LT(bare_rate(GetParam()), kReserve * kTicksPerSecond) << "a leg received " << fewest << " samples";
    GTEST_SKIP() << "this computer exchanges the samples of " << bare_rate(GetParam())
                 << " ticks a second and no more: how many arrive at 1 kHz says nothing of the nodes";
  }
}

INSTANTIATE_TEST_SUITE_P(Over, RealTimeTrot, testing::ValuesIn(tested_vendors("mixed")),
                         [](const auto& dds) { return std::string(dds.param); });

}  // namespace realtime_test
}  // namespace farrier::test
