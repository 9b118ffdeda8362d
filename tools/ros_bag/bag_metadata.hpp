#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros_view/robot_messages.hpp"

namespace farrier::ros_bag {

/// Content of a bag of one file, as rosbag2 describes it.
struct BagContent {
  struct TopicCount {
    ros_view::Topic topic;
    std::uint64_t messages = 0;
  };
  std::string file;  ///< its name, without a folder
  std::vector<TopicCount> topics;
  std::uint64_t messages = 0;
  std::uint64_t first_ns = 0, last_ns = 0;  ///< of its messages
};

/// The QoS profile of a topic as rosbag2 writes it until version 8 of its metadata, which Humble to Rolling read: YAML with
/// the numbers of rmw.
std::string qos_profiles(const ros_view::Topic& topic);

/// The metadata of a bag, version 8, as YAML. It is the value of rosbag2_bagfile_information in metadata.yaml, and
/// serialized_metadata in the MCAP file. `indent`: spaces before each line.
std::string bag_information(const BagContent& content, int indent);

}  // namespace farrier::ros_bag
