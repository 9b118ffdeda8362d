// The real-time clock on a computer that may be no real-time one: what must hold there, too.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "farrier_command.hpp"

namespace farrier::test {
namespace {

constexpr const char* kDuration = "3";
constexpr double kTicks = 3000;
constexpr double kJointsPerLeg = 3;
constexpr double kMayBeMissing = 0.2;  // best effort, on a computer that others use

class RealTimeTrot : public testing::TestWithParam<const char*> {
 protected:
  RealTimeTrot() {
    run_farrier({"trot", "--clock", "realtime", "--dds", GetParam(), "--duration", kDuration, "--out",
                 scratch_.file("out")},
                &output_);
    run_ = read_json(scratch_.file("out/figures.json"));
  }

  double figure(const std::string& name) const {
    for (const auto& entry : run_["figures"]) {
      if (entry["name"] == name && entry["value"].is_number()) {
        return entry["value"];
      }
    }
    ADD_FAILURE() << "no figure " << name;
    return NAN;
  }

  ScratchDirectory scratch_;
  std::string output_;
  nlohmann::json run_;
};

TEST_P(RealTimeTrot, EndsWithTheFiguresOfEveryProcess) {
  ASSERT_FALSE(run_.is_discarded()) << output_;
  EXPECT_EQ(run_["run"]["processes"].size(), 8u);
  for (const char* leg : {"lf", "rf", "lh", "rh"}) {
    const std::string received =
        std::string("trot.packets.joint_node_") + leg + ".joint_sensors.received";
    EXPECT_GE(figure(received), (1.0 - kMayBeMissing) * kJointsPerLeg * kTicks) << received;
    EXPECT_LE(figure(received), kJointsPerLeg * kTicks) << received;
  }
  EXPECT_NEAR(figure("trot.ticks"), kTicks, 1.0);
  EXPECT_GT(figure("trot.latency_p50_us"), 0.0);
  EXPECT_LE(figure("trot.latency_p50_us"), figure("trot.latency_p99_us"));
}

INSTANTIATE_TEST_SUITE_P(Over, RealTimeTrot, testing::Values("cyclone", "fast", "mixed"),
                         [](const auto& dds) { return std::string(dds.param); });

}  // namespace
}  // namespace farrier::test
