// farrier echo and farrier topics beside a running trot; echo, record and info where nothing comes.

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

#include "beside_a_trot.hpp"

namespace farrier::test {
namespace echo_test {

using namespace std::chrono_literals;

class Echo : public BesideATrot {
 protected:
  /// The lines of samples. The output holds standard error too, where echo says after some seconds that nothing comes;
  /// on a busy machine discovery alone may take as long.
  static std::vector<std::string> lines_of(std::vector<std::string> arguments, const std::string& vendor) {
    arguments.insert(arguments.begin(), "echo");
    const std::vector<std::string> where = beside(vendor);
    arguments.insert(arguments.end(), where.begin(), where.end());
    std::string output;
    EXPECT_EQ(run_farrier(arguments, &output), 0) << output;
    std::vector<std::string> lines;
    std::istringstream stream(output);
    for (std::string line; std::getline(stream, line);) {
      if (!line.starts_with("farrier echo: ")) {
        lines.push_back(line);
      }
    }
    return lines;
  }
};

TEST_F(Echo, PrintsTheSamplesOfOneJoint) {
  for_both_vendors([](const std::string& vendor) {
    const auto lines = lines_of({"joint/measurement", "--joint", "rh_kfe", "--count", "5"}, vendor);
    ASSERT_EQ(lines.size(), 5u);
    for (const std::string& line : lines) {
      EXPECT_TRUE(line.starts_with("joint/measurement: {joint: rh_kfe, tick: ")) << line;
      EXPECT_TRUE(line.ends_with("}")) << line;
    }
  });
}

TEST_F(Echo, GivesALateJoinerTheAnnouncements) {
  for_both_vendors([](const std::string& vendor) {
    const auto lines = lines_of({"system/mode", "joint/controller_gains", "--count", "3"}, vendor);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_TRUE(lines[0].find("generation: ") != std::string::npos || lines[0].find("mode: ") != std::string::npos)
        << lines[0];
  });
}

TEST_F(Echo, HearsEveryRouteOfATopic) {
  for_both_vendors([](const std::string& vendor) {
    std::set<std::string> joints;
    for (const std::string& line : lines_of({"joint/sensors", "--count", "200"}, vendor)) {
      joints.insert(line.substr(0, line.find(',')));
    }
    EXPECT_EQ(joints.size(), 12u);
  });
}

// One vendor after the other: each command would count the readers of the other's.
// On a busy machine discovery takes seconds.
TEST_F(Echo, TopicsListsWritersReadersAndRates) {
  for (const char* vendor : {"cyclone", "fast"}) {
    SCOPED_TRACE(vendor);
    std::string output;
    std::vector<std::string> arguments = beside(vendor);
    arguments.insert(arguments.begin(), {"topics", "--json", "--look", "12"});
    ASSERT_EQ(run_farrier(arguments, &output), 0) << output;
    std::map<std::string, nlohmann::json> topics;
    for (const nlohmann::json& topic : nlohmann::json::parse(output)) {
      topics[topic.at("topic")] = topic;
    }
    const nlohmann::json& sensors = topics.at("joint/sensors");
    EXPECT_EQ(sensors.at("writers").at("cyclone"), 4);  // sim_bridge has one for each leg
    EXPECT_EQ(sensors.at("readers").at("fast"), 4);     // each leg's joint_node
    EXPECT_EQ(sensors.at("types"), nlohmann::json{"wire::JointSensors"});
    EXPECT_GT(sensors.at("rate_hz").get<double>(), 12.0);
    EXPECT_EQ(topics.at("system/mode").at("writers").at("fast"), 1);
    EXPECT_EQ(topics.at("joint/model_estimate").at("writers").at("cyclone"), 1);
  }
}

TEST(EchoCommand, RefusesWhatItDoesNotKnowAndNamesWhatThereIs) {
  std::string output;
  EXPECT_EQ(run_farrier({"echo", "joint/sensor"}, &output), 2);
  EXPECT_NE(output.find("joint/sensors"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"echo", "joint/sensors", "--joint", "lf_elbow"}, &output), 2);
  EXPECT_NE(output.find("'lf_elbow'"), std::string::npos) << output;
}

TEST(EchoCommand, SaysWhereToAskWhenNothingComes) {
  FarrierCommand echo({"echo", "joint/sensors", "--domain", "99"});
  EXPECT_TRUE(echo.says("nothing comes in domain 99; why: farrier doctor --domain 99", 20s)) << echo.output();
  echo.signal(SIGINT);
  EXPECT_EQ(echo.wait(10s), 130);
}

TEST(RecordCommand, SaysWhereToAskWhenNothingCame) {
  const ScratchDirectory scratch;
  std::string output;
  EXPECT_EQ(run_farrier({"record", scratch.file("x.mcap"), "--domain", "99", "--duration", "0.5"}, &output), 1);
  EXPECT_NE(output.find("nothing came; why: farrier doctor --domain 99"), std::string::npos) << output;
}

TEST(RecordCommand, RefusesWhatItCannotWriteAndWhatItDoesNotKnow) {
  std::string output;
  EXPECT_EQ(run_farrier({"record", "/nowhere/x.mcap", "--domain", "99"}, &output), 2);
  EXPECT_NE(output.find("/nowhere/x.mcap"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"record", "/tmp/x.mcap", "--topics", "joint/sensor"}, &output), 2);
  EXPECT_NE(output.find("joint/sensors"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"info", "/nowhere/x.mcap"}, &output), 2);
  EXPECT_EQ(run_farrier({"info", "/etc/passwd"}, &output), 2);
  EXPECT_NE(output.find("not an MCAP file"), std::string::npos) << output;
}

}  // namespace echo_test
}  // namespace farrier::test
