// farrier monitor --foxglove beside a trot: npm's client of Foxglove's protocol decodes every channel.

#include <gtest/gtest.h>

#include <csignal>
#include <set>

#include "tests/system/farrier_command.hpp"
#include "tools/tool_process/tool_process.hpp"

namespace farrier::test {
namespace foxglove_test {

using nlohmann::json;

/// Runs a script of tests/ros/npm; returns the JSON that it prints.
json run_script(const std::vector<std::string>& arguments) {
  const ScratchDirectory scratch;
  const auto ran = run_tool({"node", "nodejs"}, arguments, FARRIER_ROS_NPM, scratch.file("said.json"));
  EXPECT_TRUE(ran.ok()) << ran.error().message;
  return ran ? read_json(scratch.file("said.json")) : json();
}

class Foxglove : public testing::Test {
 protected:
  Foxglove() : trot_({"trot", "--world", "ideal", "--duration", "600", "--out", scratch_.file("out")}) {
    EXPECT_TRUE(trot_.says("trot: tick 0 of")) << trot_.output();
    trot_.renice(5);  // in lock-step it takes all of the processors that others leave
  }
  ~Foxglove() override {
    trot_.renice(0);
    trot_.signal(SIGINT);
    trot_.wait();
  }
  /// "ws://127.0.0.1:34567", as the monitor says.
  static std::string url_of(const FarrierCommand& monitor) {
    EXPECT_TRUE(monitor.says("Foxglove at ws://")) << monitor.output();
    const std::string output = monitor.output();
    const std::size_t at = std::min(output.find("ws://"), output.size());
    return output.substr(at, output.find('\n', at) - at);
  }
  const ScratchDirectory scratch_;
  FarrierCommand trot_;
};

/// Texts of a JSON document, at any depth.
void texts_of(const json& value, std::vector<std::string>& texts) {
  if (value.is_string()) {
    texts.push_back(value);
  }
  if (value.is_structured()) {
    for (const json& one : value) {
      texts_of(one, texts);
    }
  }
}

TEST_F(Foxglove, ViewersDecodeEveryChannelAndHostileOnesChangeNothing) {
  FarrierCommand monitor({"monitor", "--domain", std::to_string(trot_.domain()), "--foxglove", ":0"});
  const std::string url = url_of(monitor);
  const json seen = run_script({"foxglove_client.mjs", url, "foxglove.sdk.v1"});
  EXPECT_EQ(seen.at("subprotocol"), "foxglove.sdk.v1");
  EXPECT_EQ(seen.at("server").at("name"), "farrier: hyq");
  const json& topics = seen.at("topics");
  EXPECT_EQ(topics.size(), 12u);
  for (const auto& [name, topic] : topics.items()) {
    EXPECT_EQ(topic.at("encoding"), "cdr") << name;
    EXPECT_EQ(topic.at("schemaEncoding"), "ros2msg") << name;
    EXPECT_GT(topic.at("messages"), 0) << name;
  }
  EXPECT_EQ(topics.at("/hyq/joint_states").at("message").at("name").size(), 12u);
  std::vector<std::string> texts;
  texts_of(read_json(FARRIER_LAYOUT), texts);
  std::set<std::string> shown;
  for (const std::string& text : texts) {
    if (text.starts_with('/')) {
      shown.insert(text.substr(0, text.find('.')));
    }
  }
  EXPECT_GE(shown.size(), 8u);
  for (const std::string& topic : shown) {
    EXPECT_TRUE(topics.contains(topic)) << "the layout shows " << topic;
  }
  EXPECT_EQ(topics.at("/hyq/lf_foot/wrench").at("message").at("header").at("frame_id"), "lf_foot");

  const json answers = run_script({"foxglove_hostile.mjs", url});
  for (const char* text :
       {"garbage", "noObject", "deep", "unknownOp", "unknownChannel", "noNumbers", "twice", "unknownSubscription"}) {
    EXPECT_EQ(answers.at(text).get<std::string>().substr(0, 8), "status 2") << text << ": " << answers.at(text);
  }
  EXPECT_EQ(answers.at("huge"), "closed 1009");
  EXPECT_EQ(answers.at("binary"), "closed 1003");
  EXPECT_EQ(answers.at("noUtf8"), "closed 1007");
  EXPECT_EQ(answers.at("noFrame"), "closed 1002");
  EXPECT_EQ(answers.at("noProtocol"), 400);
  EXPECT_EQ(answers.at("otherProtocol"), 400);
  EXPECT_EQ(answers.at("bothProtocols"), "101 foxglove.sdk.v1");

  const json late = run_script({"foxglove_client.mjs", url, "foxglove.websocket.v1", "/hyq/robot_description"});
  const std::string urdf = late.at("topics").at("/hyq/robot_description").at("message").at("data");
  EXPECT_NE(urdf.find("<robot"), std::string::npos);

  std::string output;
  EXPECT_EQ(run_farrier({"monitor", "--foxglove", url.substr(5)}, &output), 2);
  EXPECT_NE(output.find("Address already in use"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"monitor", "--foxglove", "everywhere"}, &output), 2);
  EXPECT_NE(output.find("is no address to listen on"), std::string::npos) << output;

  monitor.signal(SIGINT);
  EXPECT_EQ(monitor.wait(), 130);
  EXPECT_NE(monitor.output().find("0 dropped for slow viewers"), std::string::npos) << monitor.output();
}

}  // namespace foxglove_test
}  // namespace farrier::test
