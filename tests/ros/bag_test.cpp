// A recording as a bag of rosbag2: npm's readers of MCAP, YAML and ROS 2 messages see what the recording has.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include "recording/visit_sample.hpp"
#include "signals/tick_of.hpp"
#include "tests/system/farrier_command.hpp"
#include "tools/playback/recorded_run.hpp"
#include "tools/tool_process/tool_process.hpp"

namespace farrier::test {
namespace bag_test {

using nlohmann::json;
namespace fs = std::filesystem;

json read_bag(const std::string& folder) {
  const ScratchDirectory scratch;
  const auto ran =
      run_tool({"node", "nodejs"}, {"read_bag.mjs", fs::absolute(folder)}, FARRIER_ROS_NPM, scratch.file("bag.json"));
  EXPECT_TRUE(ran.ok()) << ran.error().message;
  return ran ? read_json(scratch.file("bag.json")) : json();
}

/// Number of ticks of each topic of a recording.
std::map<bus::TopicId, std::size_t> ticks_of(const std::string& path) {
  std::map<bus::TopicId, std::set<Tick>> ticks;
  auto run = playback::RecordedRun::open(path).value();
  for (recording::Sample sample; run.next(sample);) {
    recording::visit_sample(sample, [&](const auto& signal) { ticks[sample.topic].insert(signals::tick_of(signal)); });
  }
  std::map<bus::TopicId, std::size_t> counts;
  for (const auto& [topic, all] : ticks) {
    counts[topic] = all.size();
  }
  return counts;
}

class Bag : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_ = std::make_unique<ScratchDirectory>();
    // In a second the robot does not get as far as a trot has to, which is not the subject.
    std::string output;
    run_farrier({"trot", "--world", "ideal", "--duration", "1", "--no-comparison", "--record", recording(), "--out",
                 scratch_->file("out")},
                &output);
    ASSERT_TRUE(fs::exists(recording())) << output;
  }
  static void TearDownTestSuite() { scratch_.reset(); }
  static std::string recording() { return scratch_->file("run.mcap"); }
  static inline std::unique_ptr<ScratchDirectory> scratch_;
};

TEST_F(Bag, HasAMessageForEveryTickOfARecordingAtItsRate) {
  const std::string folder = scratch_->file("bag");
  std::string output;
  ASSERT_EQ(run_farrier({"export", "--ros2", recording(), folder, "--rate", "1000"}, &output), 0) << output;
  const json bag = read_bag(folder);
  const json& topics = bag.at("topics");
  auto ticks = ticks_of(recording());
  using enum bus::TopicId;
  EXPECT_EQ(topics.at("/hyq/joint_states").at("messages"), ticks[kJointSensors]);
  EXPECT_EQ(topics.at("/hyq/imu").at("messages"), ticks[kBodyImu]);
  EXPECT_EQ(topics.at("/hyq/odom").at("messages"), ticks[kBodyState]);
  EXPECT_EQ(topics.at("/hyq/rh_foot/wrench").at("messages"), ticks[kBodyState]);
  EXPECT_EQ(topics.at("/hyq/robot_description").at("messages"), 1);
  EXPECT_EQ(topics.size(), 12u);
  EXPECT_GE(ticks[kJointSensors], 1000u);
  EXPECT_EQ(topics.at("/hyq/joint_states").at("last").at("name").size(), 12u);
  std::uint64_t sum = 0;
  for (const auto& [name, topic] : topics.items()) {
    EXPECT_EQ(topic.at("encoding"), "cdr");
    EXPECT_EQ(topic.at("schemaEncoding"), "ros2msg");
    EXPECT_EQ(topic.at("hash").get<std::string>().substr(0, 7), "RIHS01_");
    EXPECT_EQ(topic.at("qos").at("reliability"), 1) << name;
    sum += topic.at("messages").get<std::uint64_t>();
  }
  EXPECT_EQ(topics.at("/hyq/robot_description").at("qos").at("durability"), 1) << "transient local";
  EXPECT_EQ(topics.at("/hyq/imu").at("qos").at("durability"), 2) << "volatile";
  EXPECT_EQ(bag.at("profile"), "ros2");
  EXPECT_EQ(bag.at("statistics"), sum);
}

TEST_F(Bag, SaysTheSameInMetadataYamlAndInTheFile) {
  const std::string folder = scratch_->file("said");
  std::string output;
  ASSERT_EQ(run_farrier({"export", "--ros2", recording(), folder + "/"}, &output), 0) << output;
  const json bag = read_bag(folder);
  const json& information = bag.at("information");
  EXPECT_EQ(information, bag.at("inFile"));
  EXPECT_EQ(information.at("version"), 8);
  EXPECT_EQ(information.at("storage_identifier"), "mcap");
  EXPECT_EQ(information.at("message_count"), bag.at("statistics"));
  EXPECT_EQ(information.at("relative_file_paths"), json::array({"said_0.mcap"}));
  ASSERT_EQ(information.at("topics_with_message_count").size(), bag.at("topics").size());
  for (const json& one : information.at("topics_with_message_count")) {
    const json& topic = bag.at("topics").at(one.at("topic_metadata").at("name").get<std::string>());
    EXPECT_EQ(one.at("message_count"), topic.at("messages"));
    EXPECT_EQ(one.at("topic_metadata").at("type"), topic.at("type"));
    EXPECT_EQ(one.at("topic_metadata").at("type_description_hash"), topic.at("hash"));
  }
}

TEST_F(Bag, OfARecordingThatLacksTopicsIsWithoutThemAndSaysSo) {
  const std::string part = scratch_->file("part.mcap");
  auto run = playback::RecordedRun::open(recording()).value();
  auto writer = recording::RunFileWriter::create(part, run.facts()).value();
  for (recording::Sample sample; run.next(sample);) {
    if (sample.topic == bus::TopicId::kJointSensors) {
      writer.write(sample);
    }
  }
  ASSERT_TRUE(writer.finish({}).ok());
  std::string output;
  ASSERT_EQ(run_farrier({"export", "--ros2", part, scratch_->file("part")}, &output), 0);
  EXPECT_NE(output.find("without /hyq/imu: the recording has no samples for it"), std::string::npos) << output;
  const json topics = read_bag(scratch_->file("part")).at("topics");
  EXPECT_EQ(topics.size(), 3u) << "joint_states, dynamic_joint_states, robot_description";
}

TEST_F(Bag, ARefusalLeavesNoFolder) {
  const std::string folder = scratch_->file("refused");
  std::string output;
  EXPECT_EQ(run_farrier({"export", "--ros2", scratch_->file("out/trace.csv"), folder}, &output), 2) << output;
  EXPECT_EQ(run_farrier({"export", "--ros2", recording(), scratch_->file("none/bag")}, &output), 2) << output;
  EXPECT_EQ(run_farrier({"export", recording(), folder}, &output), 2) << output;
  EXPECT_FALSE(fs::exists(folder) || fs::exists(folder + ".part"));
  fs::create_directory(folder);
  EXPECT_EQ(run_farrier({"export", "--ros2", recording(), folder}, &output), 2);
  EXPECT_NE(output.find("is there already: give the name of a folder to be made"), std::string::npos) << output;
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace bag_test
}  // namespace farrier::test
