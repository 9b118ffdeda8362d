#include "tools/ros_bag/bag_metadata.hpp"

#include <nlohmann/json.hpp>

namespace farrier::ros_bag {
namespace {

// Numbers of rmw/types.h.
constexpr int kKeepLast = 1, kReliable = 1, kTransientLocal = 1, kVolatile = 2, kAutomatic = 1;

// RMW_DURATION_INFINITE
constexpr const char* kInfinite = "\n    sec: 9223372036\n    nsec: 854775807\n";

/// A string of JSON is one of YAML.
std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

std::string qos_profiles(const ros_view::Topic& topic) {
  return "- history: " + std::to_string(kKeepLast) + "\n  depth: " + std::to_string(topic.depth) +
         "\n  reliability: " + std::to_string(kReliable) +
         "\n  durability: " + std::to_string(topic.kept ? kTransientLocal : kVolatile) + "\n  deadline:" + kInfinite +
         "  lifespan:" + kInfinite + "  liveliness: " + std::to_string(kAutomatic) +
         "\n  liveliness_lease_duration:" + kInfinite + "  avoid_ros_namespace_conventions: false\n";
}

std::string bag_information(const BagContent& content, int indent) {
  std::string text;
  const auto line = [&](int depth, const std::string& entry) {
    text += std::string(static_cast<std::size_t>(indent + 2 * depth), ' ') + entry + "\n";
  };
  const std::string start = "nanoseconds_since_epoch: " + std::to_string(content.first_ns);
  const std::string duration = "nanoseconds: " + std::to_string(content.last_ns - content.first_ns);
  const std::string count = "message_count: " + std::to_string(content.messages);
  line(0, "version: 8");
  line(0, "storage_identifier: mcap");
  line(0, "duration:");
  line(1, duration);
  line(0, "starting_time:");
  line(1, start);
  line(0, count);
  line(0, "topics_with_message_count:");
  for (const BagContent::TopicCount& one : content.topics) {
    line(1, "- topic_metadata:");
    line(4, "name: " + quoted(one.topic.name));
    line(4, "type: " + one.topic.type);
    line(4, "serialization_format: cdr");
    line(4, "offered_qos_profiles: " + quoted(qos_profiles(one.topic)));
    line(4, "type_description_hash: " + one.topic.type_hash);
    line(2, "message_count: " + std::to_string(one.messages));
  }
  line(0, "compression_format: \"\"");
  line(0, "compression_mode: \"\"");
  line(0, "relative_file_paths:");
  line(1, "- " + quoted(content.file));
  line(0, "files:");
  line(1, "- path: " + quoted(content.file));
  line(2, "starting_time:");
  line(3, start);
  line(2, "duration:");
  line(3, duration);
  line(2, count);
  line(0, "custom_data: {}");
  line(0, "ros_distro: \"\"");
  return text;
}

}  // namespace farrier::ros_bag
