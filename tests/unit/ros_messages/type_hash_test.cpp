#include <gtest/gtest.h>

#include "ros_messages/type_description.hpp"

namespace farrier::ros_messages {
namespace type_hash_test {

// Published hashes of ROS 2, equal in Iron, Jazzy and later.
TEST(TypeHash, IsThatOfRos) {
  EXPECT_EQ(type_hash<std_msgs::String>(), "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18");
  EXPECT_EQ(type_hash<std_msgs::Bool>(), "RIHS01_feb91e995ff9ebd09c0cb3d2aed18b11077585839fb5db80193b62d74528f6c9");
  EXPECT_EQ(type_hash<sensor_msgs::JointState>(),
            "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e");
  EXPECT_EQ(type_hash<sensor_msgs::Imu>(), "RIHS01_7d9a00ff131080897a5ec7e26e315954b8eae3353c3f995c55faf71574000b5b");
  EXPECT_EQ(type_hash<tf2_msgs::TFMessage>(),
            "RIHS01_e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087");
  EXPECT_EQ(type_hash<geometry_msgs::WrenchStamped>(),
            "RIHS01_8dc3deaf06b2ab281f9f9a742a8961c328ca7cec16e3fd6586d3a5c83fa78f77");
  EXPECT_EQ(type_hash<nav_msgs::Odometry>(), "RIHS01_3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0");
  EXPECT_EQ(type_hash<diagnostic_msgs::DiagnosticArray>(),
            "RIHS01_5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e");
  EXPECT_EQ(type_hash<geometry_msgs::Twist>(),
            "RIHS01_9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a");
  EXPECT_EQ(type_hash<geometry_msgs::TwistStamped>(),
            "RIHS01_5f0fcd4f81d5d06ad9b4c4c63e3ea51b82d6ae4d0558f1d475229b1121db6f64");
  EXPECT_EQ(type_hash<rosgraph_msgs::Clock>(),
            "RIHS01_692f7a66e93a3c83e71765d033b60349ba68023a8c689a79e48078bcb5c58564");
  EXPECT_EQ(type_hash<rcl_interfaces::Log>(),
            "RIHS01_e28ce254ca8abc06abf92773b74602cdbf116ed34fbaf294fb9f81da9f318eac");
  EXPECT_EQ(type_hash<control_msgs::DynamicJointState>(),
            "RIHS01_18024c98a62697680f581108eeed40b28fb4542fa0ac5a8e36f56c62b6813d26");
  EXPECT_EQ(type_hash<rmw_dds_common::ParticipantEntitiesInfo>(),
            "RIHS01_91a0593bacdcc50ea9bdcf849a938b128412cc1ea821245c663bcd26f83c295e");
}

TEST(MessageText, HasTheFieldsAndThenTheOtherTypes) {
  EXPECT_EQ(message_text(describe<std_msgs::Header>()),
            "builtin_interfaces/Time stamp\nstring frame_id\n" + std::string(80, '=') +
                "\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n");
  const std::string status = message_text(describe<diagnostic_msgs::DiagnosticStatus>());
  EXPECT_EQ(status.find("byte level\nstring name\n"), 0u) << status;
  EXPECT_NE(message_text(describe<geometry_msgs::PoseWithCovariance>()).find("float64[36] covariance\n"),
            std::string::npos);
}

}  // namespace type_hash_test
}  // namespace farrier::ros_messages
