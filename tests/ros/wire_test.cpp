// A bare Cyclone DDS program, which knows nothing of our nodes, looks at one on the wire.

#include <dds/dds.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <map>
#include <thread>

#include "bus_ros/cyclone_ros_endpoints.hpp"
#include "bus_ros/ros_domain.hpp"
#include "bus_ros/ros_node.hpp"

namespace farrier::bus_ros {
namespace wire_test {

using namespace std::chrono_literals;
using Info = ros_messages::rmw_dds_common::ParticipantEntitiesInfo;

const Network kNetwork{.domain = 62, .address = "127.0.0.1", .peers = {}};

std::string user_data(const dds_qos_t* qos) {
  void* data = nullptr;
  std::size_t size = 0;
  std::string text;
  if (dds_qget_userdata(qos, &data, &size) && data != nullptr) {
    text.assign(static_cast<const char*>(data), size);
    dds_free(data);
  }
  return text;
}

struct Endpoint {
  std::string type;
  std::string user_data;
  dds_reliability_kind_t reliability{};
  dds_durability_kind_t durability{};
  dds_data_representation_id_t representation{};
  bool partitions = true;
  Gid gid{};
};

/// Every endpoint of the builtin topic that Cyclone has found, by the name of its topic.
std::map<std::string, Endpoint> endpoints_of(dds_entity_t reader) {
  std::map<std::string, Endpoint> all;
  void* samples[64] = {};
  dds_sample_info_t infos[64];
  const dds_return_t count = dds_read(reader, samples, infos, 64, 64);
  for (dds_return_t i = 0; i < count; ++i) {
    const auto& found = *static_cast<const dds_builtintopic_endpoint_t*>(samples[i]);
    Endpoint endpoint{.type = found.type_name, .user_data = user_data(found.qos)};
    dds_duration_t blocking = 0;
    dds_qget_reliability(found.qos, &endpoint.reliability, &blocking);
    dds_qget_durability(found.qos, &endpoint.durability);
    std::uint32_t many = 0;
    dds_data_representation_id_t* representations = nullptr;
    if (dds_qget_data_representation(found.qos, &many, &representations) && many == 1) {
      endpoint.representation = representations[0];
    }
    dds_free(representations);
    std::uint32_t partitions = 0;
    endpoint.partitions = dds_qget_partition(found.qos, &partitions, nullptr) && partitions > 0;
    std::copy(std::begin(found.key.v), std::end(found.key.v), endpoint.gid.begin());
    all[found.topic_name] = endpoint;
  }
  if (count > 0) {
    dds_return_loan(reader, samples, count);
  }
  return all;
}

class Wire : public testing::Test {
 protected:
  Wire()
      : domain_(open_ros_domain(kNetwork).value()),
        participant_(join_ros_domain(domain_).value()),
        publications_(dds_create_reader(participant_, DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr)),
        node_(RosNode::create({.network = kNetwork, .name = "farrier", .ros_namespace = "/hyq", .graph = Graph::kJazzy})
                  .value()),
        writer_(node_.writer<ros_messages::sensor_msgs::JointState>("joint_states").value()) {}
  ~Wire() override { dds_delete(domain_); }

  Endpoint found(const std::string& topic) const {
    for (int i = 0; i < 1000; ++i) {
      const auto all = endpoints_of(publications_);
      if (const auto endpoint = all.find(topic); endpoint != all.end()) {
        return endpoint->second;
      }
      std::this_thread::sleep_for(10ms);
    }
    ADD_FAILURE() << topic << " is not found";
    return {};
  }

  dds_entity_t domain_, participant_, publications_;
  RosNode node_;
  RosWriter<ros_messages::sensor_msgs::JointState> writer_;
};

TEST_F(Wire, ATopicHasTheNameTypeHashAndQosOfRos) {
  const Endpoint endpoint = found("rt/hyq/joint_states");
  EXPECT_EQ(endpoint.type, "sensor_msgs::msg::dds_::JointState_");
  EXPECT_EQ(endpoint.user_data, "typehash=RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e;");
  EXPECT_EQ(endpoint.reliability, DDS_RELIABILITY_RELIABLE);
  EXPECT_EQ(endpoint.durability, DDS_DURABILITY_VOLATILE);
  EXPECT_EQ(endpoint.representation, DDS_DATA_REPRESENTATION_XCDR1);
  EXPECT_FALSE(endpoint.partitions);
}

TEST_F(Wire, TheGraphMessageNamesTheNodeAndTheGidsOfItsWriters) {
  const Endpoint joints = found("rt/hyq/joint_states");
  const Endpoint graph = found("ros_discovery_info");
  EXPECT_EQ(graph.type, "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_");
  EXPECT_EQ(graph.durability, DDS_DURABILITY_TRANSIENT_LOCAL);
  EXPECT_NE(graph.user_data.find("typehash=RIHS01_91a0593b"), std::string::npos) << graph.user_data;
  const auto reader = open_reader(participant_, "ros_discovery_info", Info::kRosName,
                                  {.reliable = true, .transient_local = true, .depth = 1}, "")
                          .value();
  std::optional<Info> newest;
  for (int i = 0; i < 1000 && !newest; ++i) {
    reader->take([&](std::span<const std::uint8_t> cdr, std::uint64_t) { newest = ros_messages::from_cdr<Info>(cdr); });
    std::this_thread::sleep_for(10ms);
  }
  ASSERT_TRUE(newest.has_value());
  ASSERT_EQ(newest->node_entities_info_seq.size(), 1u);
  const auto& node = newest->node_entities_info_seq.front();
  EXPECT_EQ(node.node_namespace, "/hyq");
  EXPECT_EQ(node.node_name, "farrier");
  ASSERT_EQ(node.writer_gid_seq.size(), 1u);
  EXPECT_EQ(node.writer_gid_seq.front().data, joints.gid) << "the GUID that discovery has of the writer";
  EXPECT_TRUE(std::equal(joints.gid.begin(), joints.gid.begin() + 12, newest->gid.data.begin()))
      << "the participant of the writer";
}

TEST_F(Wire, TheParticipantHasAnEnclave) {
  found("rt/hyq/joint_states");
  const dds_entity_t reader = dds_create_reader(participant_, DDS_BUILTIN_TOPIC_DCPSPARTICIPANT, nullptr, nullptr);
  void* samples[16] = {};
  dds_sample_info_t infos[16];
  const dds_return_t count = dds_read(reader, samples, infos, 16, 16);
  ASSERT_EQ(count, 2) << "this one and the node";
  for (dds_return_t i = 0; i < count; ++i) {
    EXPECT_EQ(user_data(static_cast<const dds_builtintopic_participant_t*>(samples[i])->qos), "enclave=/;");
  }
  dds_return_loan(reader, samples, count);
}

}  // namespace wire_test
}  // namespace farrier::bus_ros
