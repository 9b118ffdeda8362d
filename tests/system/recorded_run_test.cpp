// farrier trot --record, and what is done with the recording.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "bus/topics.hpp"
#include "farrier_command.hpp"

namespace farrier::test {
namespace recorded_run_test {

using nlohmann::json;

class RecordedRun : public testing::TestWithParam<const char*> {
 protected:
  json info() {
    EXPECT_EQ(run_farrier({"info", path_, "--json"}, &output_), 0) << output_;
    return json::parse(output_);
  }

  const ScratchDirectory scratch_;
  const std::string path_ = scratch_.file("run.mcap");
  std::string output_;
};

TEST_P(RecordedRun, LacksNothingInLockstepAndServesEveryTool) {
  constexpr int kTicks = 4000;
  ASSERT_EQ(run_farrier({"trot", "--world", "bench", "--dds", GetParam(), "--duration", "4", "--seed", "5", "--record",
                         path_, "--out", scratch_.file("out")},
                        &output_),
            0)
      << output_;
  const json recorded = info();
  EXPECT_TRUE(recorded.at("whole"));
  EXPECT_EQ(recorded.at("run").at("seed"), "5");
  EXPECT_EQ(recorded.at("run").at("clock"), "lockstep");
  for (const char* topic : {"joint/sensors", "joint/valve_command", "joint/measurement"}) {
    EXPECT_EQ(recorded.at("topics").at(topic).at("samples"), 12 * kTicks) << topic;
  }
  for (const bus::TopicSpec& topic : bus::topics()) {
    EXPECT_EQ(recorded.at("topics").at(topic.name).at("lost"), 0) << topic.name;
  }
  EXPECT_GE(recorded.at("topics").at("lf/joint/summary").at("samples"), 12 * (kTicks / 20 - 1));
  EXPECT_EQ(recorded.at("topics").at("lf/joint/model_estimate").at("samples"), 12 * kTicks / 100);

  EXPECT_EQ(run_farrier({"replay", path_, "--rerun", "estimator"}, &output_), 0) << output_;
  EXPECT_NE(output_.find(" estimates compared, 0 different"), std::string::npos) << output_;

  const std::string estimates = scratch_.file("estimates.csv");
  EXPECT_EQ(run_farrier({"identify", path_, "--joint", "lf_kfe", "--csv", estimates}, &output_), 0) << output_;
  EXPECT_NE(output_.find("lf_kfe"), std::string::npos) << output_;
  EXPECT_EQ(output_.find("rf_kfe"), std::string::npos) << output_;
  std::string line;
  std::ifstream file(estimates);
  std::getline(file, line);
  EXPECT_EQ(line.substr(0, 29), "time_s,joint_name,joint,tick,");

  EXPECT_EQ(run_farrier({"diagnose", path_, "--joint", "lf_kfe"}, &output_), 0) << output_;
  EXPECT_EQ(run_farrier({"diagnose", path_, "--joint", "tail"}, &output_), 2) << output_;
  EXPECT_NE(output_.find("has no joint 'tail'"), std::string::npos) << output_;
}

INSTANTIATE_TEST_SUITE_P(Over, RecordedRun, testing::Values("cyclone", "fast"),
                         [](const auto& vendor) { return std::string(vendor.param); });

}  // namespace recorded_run_test
}  // namespace farrier::test
