#pragma once

#include <memory>
#include <optional>
#include <string>

#include "bus_ros/ros_endpoints.hpp"
#include "bus_ros/ros_network.hpp"
#include "core/result.hpp"
#include "ros_messages/type_description.hpp"

namespace farrier::bus_ros {

/// A node of ROS 2 by Cyclone DDS, without ROS: topics, type hashes and the graph message, as rmw_cyclonedds has them.
/// docs/ros2.md says what other nodes see. One thread uses it.
class RosNode {
 public:
  struct Options {
    Network network;
    std::string name = "farrier";
    std::string ros_namespace = "/";  ///< "/" or "/hyq"
    Graph graph = Graph::kAuto;
  };

  /// Joins the domain. Refuses what Cyclone refuses.
  static Result<RosNode> create(const Options& options);
  RosNode(RosNode&&) noexcept;
  RosNode& operator=(RosNode&&) noexcept;
  /// Tells others that the node leaves.
  ~RosNode();

  /// `topic`: "/tf", or a name in the node's namespace, "joint_states". The writer must not outlive the node.
  template <ros_messages::Message M>
  Result<RosWriter<M>> writer(const std::string& topic, const RosQos& qos = {}) {
    auto raw = FARRIER_TRY(open_raw_writer(topic, M::kRosName, ros_messages::type_hash<M>(), qos));
    return RosWriter<M>(std::move(raw));
  }

  /// The same for a reader.
  template <ros_messages::Message M>
  Result<RosReader<M>> reader(const std::string& topic, const RosQos& qos) {
    auto raw = FARRIER_TRY(open_raw_reader(topic, M::kRosName, ros_messages::type_hash<M>(), qos));
    return RosReader<M>(std::move(raw));
  }

  /// Looks who is there and publishes the graph message if it has changed. Call it about once a second. Returns a
  /// sentence about a change that a user should know, else an empty text.
  std::string look();

  /// The full name of a topic in ROS: "/hyq/joint_states".
  std::string full_name(const std::string& topic) const;

  /// The form in which the graph message is published now.
  Graph acting_graph() const noexcept;

 private:
  struct Parts;
  explicit RosNode(std::unique_ptr<Parts> parts);

  Result<std::shared_ptr<RawRosWriter>> open_raw_writer(const std::string& topic, const char* type,
                                                        const std::string& hash, const RosQos& qos);
  Result<std::shared_ptr<RawRosReader>> open_raw_reader(const std::string& topic, const char* type,
                                                        const std::string& hash, const RosQos& qos);

  std::unique_ptr<Parts> parts_;
};

}  // namespace farrier::bus_ros
