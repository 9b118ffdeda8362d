#include "ros_messages/cdr.hpp"

#include <gtest/gtest.h>

namespace farrier::ros_messages {
namespace cdr_test {

sensor_msgs::JointState joint_state() {
  sensor_msgs::JointState message;
  message.header.stamp = {.sec = 7, .nanosec = 8};
  message.header.frame_id = "base";
  message.name = {"lf_haa", "lf_hfe"};
  message.position = {0.5, -0.25};
  message.velocity = {1.0, 2.0};
  return message;
}

// By hand, from the rules of CDR: a string has its length with the closing zero, a double is aligned to 8 bytes behind the
// header.
TEST(Cdr, BytesAreThoseOfTheStandard) {
  std::vector<std::uint8_t> bytes;
  geometry_msgs::TwistStamped twist;
  twist.header.stamp.sec = 1;
  twist.header.frame_id = "ab";
  twist.twist.angular.z = 1.0;
  to_cdr(twist, bytes);
  const std::vector<std::uint8_t> head(bytes.begin(), bytes.begin() + 20);
  EXPECT_EQ(head, (std::vector<std::uint8_t>{0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 'a', 'b', 0, 0}));
  EXPECT_EQ(bytes.size(), 4u + 16u + 6u * 8u);
  EXPECT_EQ(bytes.back(), 0x3f) << "the last double is 1.0";
}

TEST(Cdr, AMessageReadsBackAsItself) {
  std::vector<std::uint8_t> bytes;
  to_cdr(joint_state(), bytes);
  EXPECT_EQ(from_cdr<sensor_msgs::JointState>(bytes), joint_state());
  diagnostic_msgs::DiagnosticArray array;
  array.status.push_back(
      {.level = std::byte{2}, .name = "a", .message = "b", .hardware_id = "c", .values = {{"k", "v"}}});
  to_cdr(array, bytes);
  EXPECT_EQ(from_cdr<diagnostic_msgs::DiagnosticArray>(bytes), array);
}

TEST(Cdr, NoBytesThatAreCutOffAreAMessage) {
  std::vector<std::uint8_t> bytes;
  to_cdr(joint_state(), bytes);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(from_cdr<sensor_msgs::JointState>(std::span(bytes).first(size)).has_value()) << size;
  }
}

TEST(Cdr, LengthsBeyondTheBytesAreRefused) {
  std::vector<std::uint8_t> bytes;
  to_cdr(std_msgs::String{.data = "hello"}, bytes);
  for (const int length : {0xff, 0x00, 0x07}) {
    bytes[4] = static_cast<std::uint8_t>(length);
    EXPECT_FALSE(from_cdr<std_msgs::String>(bytes).has_value()) << length;
  }
  bytes = {0, 1, 0, 0, 0xff, 0xff, 0xff, 0xff};
  EXPECT_FALSE(from_cdr<tf2_msgs::TFMessage>(bytes).has_value());
}

// SetBool or a big-endian message that is taken for this type must not read as true.
TEST(Cdr, ABoolThatIsNeitherZeroNorOneAndAnotherByteOrderAreRefused) {
  EXPECT_TRUE(from_cdr<std_msgs::Bool>(std::vector<std::uint8_t>{0, 1, 0, 0, 1})->data);
  EXPECT_FALSE(from_cdr<std_msgs::Bool>(std::vector<std::uint8_t>{0, 1, 0, 0, 7}).has_value());
  EXPECT_FALSE(from_cdr<std_msgs::Bool>(std::vector<std::uint8_t>{0, 0, 0, 0, 1}).has_value());
}

TEST(Cdr, BoundedStringsHoldTheirBound) {
  rmw_dds_common::NodeEntitiesInfo node;
  node.node_name = std::string(256, 'n');
  std::vector<std::uint8_t> bytes;
  to_cdr(node, bytes);
  EXPECT_TRUE(from_cdr<rmw_dds_common::NodeEntitiesInfo>(bytes).has_value());
  node.node_name += "n";
  to_cdr(node, bytes);
  EXPECT_FALSE(from_cdr<rmw_dds_common::NodeEntitiesInfo>(bytes).has_value());
}

}  // namespace cdr_test
}  // namespace farrier::ros_messages
