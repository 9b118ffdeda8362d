// Matching of readers: partitions, durability, and requests that an offer does not satisfy.

#include <set>
#include <thread>

#include "conformance.hpp"

namespace farrier::contract {
namespace conformance_matching_test {

using bus::Durability;
using signals::JointSensors;
using signals::SystemMode;

SystemMode mode(std::uint32_t epoch) {
  SystemMode sample;
  sample.epoch = epoch;
  return sample;
}

JointSensors sensors(int joint) {
  JointSensors sample;
  sample.joint = static_cast<std::uint16_t>(joint);
  return sample;
}

std::set<int> joints_of(const std::vector<JointSensors>& samples) {
  std::set<int> joints;
  for (const JointSensors& sample : samples) {
    joints.insert(sample.joint);
  }
  return joints;
}

TEST_P(Conformance, LateSubscriberReceivesTransientLocalMode) {
  auto writer = publisher<SystemMode>(reliable(1, Durability::kTransientLocal));
  ASSERT_TRUE(writer.publish(mode(1)));
  ASSERT_TRUE(writer.publish(mode(2)));
  auto reader = subscription<SystemMode>(reliable(1, Durability::kTransientLocal));
  const auto start = std::chrono::steady_clock::now();
  const auto received = receive(reader, 1, kLateJoinerBudget);
  RecordProperty("late_joiner_ms", static_cast<int>((std::chrono::steady_clock::now() - start) / 1ms));
  ASSERT_EQ(received.size(), 1u);
  EXPECT_EQ(received[0].epoch, 2u);
}

TEST_P(Conformance, LateSubscriberReceivesTheTransientLocalHistoryOfEveryKey) {
  constexpr int kDepth = 4;
  constexpr int kLegs = 4;
  auto writer = publisher<signals::GaitPhase>(reliable(kDepth, Durability::kTransientLocal));
  for (std::uint32_t count = 1; count <= 2 * kDepth; ++count) {
    for (std::uint16_t leg = 0; leg < kLegs; ++leg) {
      ASSERT_TRUE(writer.publish({.leg = leg, .count = count}));
    }
  }
  auto reader = subscription<signals::GaitPhase>(reliable(kDepth, Durability::kTransientLocal));
  const auto received = receive(reader, kDepth * kLegs, kLateJoinerBudget);
  std::array<std::vector<std::uint32_t>, kLegs> counts;
  for (const signals::GaitPhase& phase : received) {
    counts.at(phase.leg).push_back(phase.count);
  }
  for (const auto& of_leg : counts) {
    EXPECT_EQ(of_leg, (std::vector<std::uint32_t>{5, 6, 7, 8}));
  }
}

// The writer is volatile: a transient-local one of Cyclone repeats its history to a volatile reader of Fast DDS, too.
TEST_P(Conformance, LateVolatileSubscriberReceivesOnlyWhatIsNew) {
  auto writer = publisher<SystemMode>(reliable(4));
  auto early = subscription<SystemMode>(reliable(4));
  ASSERT_TRUE(matched(writer, early));
  ASSERT_TRUE(writer.publish(mode(1)));
  ASSERT_EQ(receive(early, 1).size(), 1u);
  // Until the first reader has acknowledged it, Cyclone repeats the sample to a late reader of Fast DDS, too.
  std::this_thread::sleep_for(kAcknowledged);
  auto late = subscription<SystemMode>(reliable(4));
  ASSERT_TRUE(matched(writer, late, 2));
  ASSERT_TRUE(writer.publish(mode(2)));
  const auto received = receive(late, 1);
  ASSERT_EQ(received.size(), 1u);
  EXPECT_EQ(received[0].epoch, 2u);
}

TEST_P(Conformance, PartitionRoutesAJointToItsProcessAlone) {
  const std::string a = "lf_haa";
  const std::string b = "lf_hfe";
  const std::string c = "lf_kfe";
  auto writer_a = publisher<JointSensors>(reliable(8), {a});
  auto writer_b = publisher<JointSensors>(reliable(8), {b});
  auto writer_c = publisher<JointSensors>(reliable(8), {c});
  auto only_a = subscription<JointSensors>(reliable(8), {a});
  auto whole_leg = subscription<JointSensors>(reliable(8), {a, b, c});
  ASSERT_TRUE(matched(writer_a, only_a, 2));
  ASSERT_TRUE(matched(writer_b, whole_leg, 1));
  ASSERT_TRUE(matched(writer_c, whole_leg, 1));
  ASSERT_TRUE(wait_until(reader_bus(), kMatchBudget, [&] { return whole_leg.status().matched_writers == 3; }));
  ASSERT_TRUE(writer_b.publish(sensors(1)));
  ASSERT_TRUE(writer_c.publish(sensors(2)));
  ASSERT_TRUE(writer_a.publish(sensors(0)));
  EXPECT_EQ(joints_of(receive(whole_leg, 3)), (std::set<int>{0, 1, 2}));
  EXPECT_EQ(joints_of(receive(only_a, 1)), (std::set<int>{0}));
  EXPECT_EQ(only_a.status().matched_writers, 1);
}

TEST_P(Conformance, WriterWithSeveralPartitionsReachesEachOnce) {
  auto writer = publisher<JointSensors>(reliable(8), {"a", "b"});
  auto of_a = subscription<JointSensors>(reliable(8), {"a"});
  auto of_both = subscription<JointSensors>(reliable(8), {"b", "a"});
  auto of_c = subscription<JointSensors>(reliable(8), {"c"});
  ASSERT_TRUE(matched(writer, of_a, 2));
  ASSERT_TRUE(matched(writer, of_both, 2));
  ASSERT_TRUE(writer.publish(sensors(5)));
  EXPECT_EQ(receive(of_a, 1).size(), 1u);
  EXPECT_EQ(receive(of_both, 1).size(), 1u);
  EXPECT_EQ(taken(of_both).size(), 0u);
  EXPECT_EQ(taken(of_c).size(), 0u);
}

TEST_P(Conformance, PartitionWithAWildcardIsRefused) {
  const auto refused = bus::Publisher<JointSensors>::create(
      writer_bus(), {bus::TopicId::kJointSensors, reliable(), {"robot/*"}});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("robot/*"), std::string::npos) << refused.error().message;
}

TEST_P(Conformance, BestEffortWriterGivesAReliableReaderNothing) {
  bus::Qos best_effort = reliable(4);
  best_effort.reliability = bus::Reliability::kBestEffort;
  auto writer = publisher<JointSensors>(best_effort);
  auto demanding = subscription<JointSensors>(reliable(4));
  auto modest = subscription<JointSensors>(best_effort);
  ASSERT_TRUE(matched(writer, modest));
  EXPECT_TRUE(wait_until(reader_bus(), kMatchBudget, [&] { return demanding.status().incompatible_qos >= 1; }));
  ASSERT_TRUE(writer.publish(sensors(1)));
  ASSERT_EQ(receive(modest, 1).size(), 1u);
  EXPECT_EQ(taken(demanding).size(), 0u);
  EXPECT_EQ(demanding.status().matched_writers, 0);
  EXPECT_EQ(writer.matched_readers(), 1);
}

TEST_P(Conformance, VolatileWriterGivesATransientLocalReaderNothing) {
  auto writer = publisher<SystemMode>(reliable(4));
  auto demanding = subscription<SystemMode>(reliable(4, Durability::kTransientLocal));
  auto modest = subscription<SystemMode>(reliable(4));
  ASSERT_TRUE(matched(writer, modest));
  EXPECT_TRUE(wait_until(reader_bus(), kMatchBudget, [&] { return demanding.status().incompatible_qos >= 1; }));
  ASSERT_TRUE(writer.publish(mode(1)));
  ASSERT_EQ(receive(modest, 1).size(), 1u);
  EXPECT_EQ(taken(demanding).size(), 0u);
  EXPECT_EQ(demanding.status().matched_writers, 0);
}

}  // namespace conformance_matching_test
}  // namespace farrier::contract
