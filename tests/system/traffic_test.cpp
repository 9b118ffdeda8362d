// Traffic between processes in lock-step: nothing is lost, nothing goes where it is not wanted.

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/processes.hpp"
#include "farrier_command.hpp"

namespace farrier::test {
namespace traffic_test {

constexpr const char* kDuration = "0.5";
constexpr long kTicks = 500;
constexpr long kJoints = 12;
constexpr std::size_t kParticipants = kPrograms.size() - 1 + kJoints;  // a joint_node per joint; not the launcher

struct Count {
  long sent = 0;
  long received = 0;
  long lost = 0;
};

/// Samples of each topic by process, and who the processes were.
struct Traffic {
  std::map<std::string, std::map<std::string, Count>> by_topic;
  std::size_t processes = 0;
  std::set<int> pids;

  long sent(const std::string& topic) const { return sum(topic, &Count::sent); }
  long received(const std::string& topic) const { return sum(topic, &Count::received); }
  long lost(const std::string& topic) const { return sum(topic, &Count::lost); }

 private:
  long sum(const std::string& topic, long Count::*what) const {
    long total = 0;
    for (const auto& [process, count] : by_topic.at(topic)) {
      total += count.*what;
    }
    return total;
  }
};

Traffic traffic_over(const std::string& dds) {
  const ScratchDirectory scratch;
  run_farrier({"trot", "--world", "bench", "--dds", dds, "--nodes", "per-joint", "--duration", kDuration, "--out",
               scratch.file("out")});
  Traffic traffic;
  const nlohmann::json figures = read_json(scratch.file("out/figures.json"));
  if (figures.is_discarded()) {
    return traffic;
  }
  for (const auto& process : figures["run"]["processes"]) {
    ++traffic.processes;
    traffic.pids.insert(process["pid"].get<int>());
    for (const auto& topic : process["topics"]) {
      traffic.by_topic[topic["topic"]][process["name"]] = {topic["sent"], topic["received"], topic["lost"]};
    }
  }
  return traffic;
}

class LockstepTraffic : public testing::TestWithParam<const char*> {};

TEST_P(LockstepTraffic, ReachesEveryoneItIsForAndNobodyElse) {
  const Traffic traffic = traffic_over(GetParam());
  const bool in_process = GetParam() == std::string("inproc");
  const std::size_t participants = kParticipants + (in_process ? 0 : 1);
  ASSERT_EQ(traffic.processes, participants);
  EXPECT_EQ(traffic.pids.size(), in_process ? 1 : participants);

  // One sample a joint and tick. Sensors and valve commands have one reader each; a reader of measurements gets all.
  for (const char* topic : {"joint/sensors", "joint/valve_command", "joint/measurement"}) {
    EXPECT_EQ(traffic.sent(topic), kJoints * kTicks) << topic;
  }
  for (const char* topic : {"joint/sensors", "joint/valve_command"}) {
    EXPECT_EQ(traffic.received(topic), traffic.sent(topic)) << topic;
  }
  for (const auto& [process, count] : traffic.by_topic.at("joint/measurement")) {
    const bool reads = count.received > 0 || process == "estimator_service";
    EXPECT_EQ(count.received, reads ? kJoints * kTicks : 0) << process;
    EXPECT_FALSE(reads && (process.starts_with("joint_node") || process == "sim_bridge")) << process;
  }
  for (const auto& [process, count] : traffic.by_topic.at("joint/sensors")) {
    if (process.starts_with("joint_node")) {
      EXPECT_EQ(count.received, kTicks) << process;
    }
  }
  // Locomotion is one tick ahead, which the last tick of a run may cut off.
  EXPECT_EQ(traffic.sent("joint/command"), kJoints * (kTicks + 1));
  EXPECT_LE(traffic.received("joint/command"), traffic.sent("joint/command"));
  EXPECT_GE(traffic.received("joint/command"), kJoints * kTicks);

  const long others = static_cast<long>(participants) - 1;
  EXPECT_EQ(traffic.sent("clock/tick_done"), others * kTicks);
  EXPECT_EQ(traffic.received("clock/tick_done"), others * kTicks);
  EXPECT_EQ(traffic.by_topic.at("clock/tick_done").at("sim_bridge").received, others * kTicks);

  for (const auto& [topic, processes] : traffic.by_topic) {
    EXPECT_EQ(traffic.lost(topic), 0) << topic;
  }
}

INSTANTIATE_TEST_SUITE_P(Over, LockstepTraffic, testing::Values("inproc", "cyclone", "fast", "mixed"),
                         [](const auto& dds) { return std::string(dds.param); });

}  // namespace traffic_test
}  // namespace farrier::test
