// Faults of a robot's DDS, made on purpose one at a time in a domain that is otherwise well.

#include <gtest/gtest.h>

#include <algorithm>

#include "bus/topics.hpp"
#include "tools/deploy/bus_findings.hpp"

namespace farrier::deploy {
namespace bus_findings_test {

using namespace std::chrono_literals;
using bus::DiscoveredEndpoint;
using bus::TopicId;

constexpr const char* kBridge = "0110aa000000000000000001";
constexpr const char* kNode = "010fbb000000000000000002";
constexpr const char* kOther = "0110cc000000000000000003";

DiscoveredEndpoint endpoint(const char* process, bool writes, TopicId topic, const std::string& partition = "hyq") {
  const bus::TopicSpec& spec = bus::spec(topic);
  return {.writes = writes,
          .participant = process,
          .topic = spec.name,
          .type = spec.type_name,
          .qos = bus::qos_for(spec, bus::ClockKind::kRealtime),
          .partitions = {partition},
          .ownership_strength = 0};
}

/// sim_bridge and a joint_node of leg lf.
bus::Discovery healthy() {
  return {{kBridge, kNode},
          {endpoint(kBridge, true, TopicId::kJointSensors, "hyq/lf"),
           endpoint(kNode, false, TopicId::kJointSensors, "hyq/lf"),
           endpoint(kNode, true, TopicId::kJointValveCommand),
           endpoint(kBridge, false, TopicId::kJointValveCommand)}};
}

const bus::NetworkOptions kNetwork{};

std::string only_finding(const bus::Discovery& found) {
  const Findings findings = bus_findings(found, "hyq", kNetwork);
  std::string all;
  for (const Finding& finding : findings) {
    EXPECT_FALSE(finding.fix.empty()) << finding.what;
    all += (all.empty() ? "" : "\n") + finding.what;
  }
  return all;
}

TEST(BusFindings, AreNoneInAHealthyDomain) { EXPECT_EQ(only_finding(healthy()), ""); }

TEST(BusFindings, SayThatNobodyIsThereAndWhereWasLooked) {
  EXPECT_EQ(only_finding({}), "nobody else is in domain 0: looked on 127.0.0.1 from 127.0.0.1");
}

TEST(BusFindings, NameThePartitionThatIsAnotherRobots) {
  bus::Discovery found = healthy();
  found.endpoints[1].partitions = {"hyq2/lf"};
  EXPECT_EQ(only_finding(found), std::string("the Fast DDS reader of process ") + kNode +
                                     " has joint/sensors in partition 'hyq2/lf', which is not robot hyq's");
}

TEST(BusFindings, NameATopicThatIsNearlyOne) {
  bus::Discovery found = healthy();
  found.endpoints[1].topic = "joint/sensor";
  EXPECT_EQ(only_finding(found), std::string("the Fast DDS reader of process ") + kNode +
                                     " has topic 'joint/sensor', which nobody else does");
}

TEST(BusFindings, LeaveTopicsOfOtherProgramsAlone) {
  bus::Discovery found = healthy();
  found.endpoints.push_back(endpoint(kOther, true, TopicId::kJointSensors));
  found.endpoints.back().topic = "rt/camera_info";
  EXPECT_EQ(only_finding(found), "");
}

TEST(BusFindings, NameATypeThatIsNotTheTopics) {
  bus::Discovery found = healthy();
  found.endpoints[1].type = "wire::JointCommand";
  EXPECT_EQ(only_finding(found), std::string("the Fast DDS reader of process ") + kNode +
                                     " has type wire::JointCommand for joint/sensors, which is of wire::JointSensors");
}

struct Misfit {
  const char* says;
  void (*spoil)(bus::Qos& offered, bus::Qos& asked);
};
void PrintTo(const Misfit& misfit, std::ostream* stream) { *stream << misfit.says; }

class QosMisfit : public testing::TestWithParam<Misfit> {};

TEST_P(QosMisfit, IsNamedByPolicyWithBothOffers) {
  bus::Discovery found = healthy();
  GetParam().spoil(found.endpoints[0].qos, found.endpoints[1].qos);
  EXPECT_EQ(only_finding(found), "joint/sensors, " + std::string(GetParam().says) +
                                     ", by the Cyclone writer of process " + kBridge +
                                     " and the Fast DDS reader of process " + kNode);
}

INSTANTIATE_TEST_SUITE_P(
    Each, QosMisfit,
    testing::Values(
        Misfit{"RELIABILITY: best effort is offered and reliable is asked for",
               [](bus::Qos&, bus::Qos& asked) { asked.reliability = bus::Reliability::kReliable; }},
        Misfit{"DURABILITY: volatile is offered and transient local is asked for",
               [](bus::Qos&, bus::Qos& asked) { asked.durability = bus::Durability::kTransientLocal; }},
        Misfit{"DEADLINE: infinite is offered and 2 ms is asked for",
               [](bus::Qos&, bus::Qos& asked) { asked.deadline = 2ms; }},
        Misfit{"LIVELINESS kind: automatic is offered and manual by topic is asked for",
               [](bus::Qos&, bus::Qos& asked) { asked.liveliness = bus::Liveliness::kManualByTopic; }},
        Misfit{"LIVELINESS lease: infinite is offered and 10 ms is asked for",
               [](bus::Qos&, bus::Qos& asked) { asked.lease = 10ms; }},
        Misfit{"OWNERSHIP: shared is offered and exclusive is asked for",
               [](bus::Qos&, bus::Qos& asked) { asked.ownership = bus::Ownership::kExclusive; }}));

TEST(BusFindings, DoNotHoldQosAgainstEndpointsThatNeverMeet) {
  bus::Discovery found = healthy();
  found.endpoints[1].partitions = {"hyq/rf"};
  found.endpoints[1].qos.reliability = bus::Reliability::kReliable;
  EXPECT_EQ(only_finding(found), "");
}

TEST(BusFindings, NameASecondProcessThatWritesWhatOneAloneMay) {
  bus::Discovery found = healthy();
  found.participants.push_back(kOther);
  found.endpoints.push_back(endpoint(kOther, true, TopicId::kJointSensors, "hyq/lf"));
  EXPECT_EQ(only_finding(found), std::string("several processes write joint/sensors of robot hyq: ") + kBridge + ", " +
                                     kOther);
}

TEST(BusFindings, NameSupervisorsOfOneStrengthAndLetAStandbyBe) {
  bus::Discovery found = healthy();
  found.endpoints.push_back(endpoint(kNode, true, TopicId::kSystemMode));
  found.endpoints.push_back(endpoint(kOther, true, TopicId::kSystemMode));
  EXPECT_EQ(only_finding(found), std::string("several processes write system/mode of robot hyq with the same "
                                             "strength: ") + kNode + ", " + kOther);
  found.endpoints.back().ownership_strength = -1;
  EXPECT_EQ(only_finding(found), "");
}

TEST(BusFindings, NameClocksThatDifferByMoreThanASampleIsOnItsWay) {
  bus::Discovery found = healthy();
  found.clocks = {{kBridge, -20ms}, {kNode, 40ms}};
  EXPECT_EQ(only_finding(found), "");
  found.clocks[0].ahead = -1500ms;
  EXPECT_EQ(only_finding(found), std::string("the clock of process ") + kBridge + " is 1.5 s behind this computer's");
  found.clocks = {{kNode, 1h}};
  EXPECT_EQ(only_finding(found), std::string("the clock of process ") + kNode + " is 3600 s ahead of this computer's");
}

}  // namespace bus_findings_test
}  // namespace farrier::deploy
