#pragma once

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "bus_ros/ros_node.hpp"

namespace farrier::test {

/// A node of a user, and what it has heard of a robot in a namespace.
class UserNode {
 public:
  explicit UserNode(int domain, const std::string& ns = "/hyq")
      : node_(bus_ros::RosNode::create({.network = {.domain = domain, .address = "127.0.0.1", .peers = {}},
                                        .name = "user",
                                        .ros_namespace = ns,
                                        .graph = bus_ros::Graph::kJazzy})
                  .value()) {}

  /// Takes what has come.
  void look() {
    joint_states_.take([this](const ros_messages::sensor_msgs::JointState& message, std::uint64_t) {
      for (std::size_t i = 0; i < message.name.size(); ++i) {
        angles_rad_[message.name[i]] = message.position[i];
      }
    });
    log_.take([this](const ros_messages::rcl_interfaces::Log& line, std::uint64_t) { lines_.push_back(line.msg); });
    diagnostics_.take([this](const ros_messages::diagnostic_msgs::DiagnosticArray& message, std::uint64_t) {
      for (const auto& status : message.status) {
        statuses_[status.name] = status.message;
      }
    });
  }

  /// Calls `act` a hundred times a second until `done` is true; false if it is not in time.
  template <class Done, class Act>
  bool until(Done&& done, Act&& act, std::chrono::seconds patience = std::chrono::seconds(20)) {
    auto next = std::chrono::steady_clock::now();
    const auto end = next + patience;
    while (std::chrono::steady_clock::now() < end) {
      look();
      if (done()) {
        return true;
      }
      act();
      next += std::chrono::milliseconds(10);
      std::this_thread::sleep_until(next);
    }
    return false;
  }
  template <class Done>
  bool until(Done&& done) {
    return until(done, [] {});
  }

  /// Newest angle; none: none was heard.
  std::optional<double> angle_rad(const std::string& joint) const {
    const auto found = angles_rad_.find(joint);
    return found == angles_rad_.end() ? std::nullopt : std::optional(found->second);
  }
  /// True if /rosout has said it since forget().
  bool was_told(const std::string& text) const {
    return std::ranges::any_of(lines_, [&](const std::string& line) { return line.find(text) != std::string::npos; });
  }
  void forget() {
    lines_.clear();
    statuses_.clear();
  }
  /// Message of a status in /diagnostics since forget(); empty: none has come.
  std::string status(const std::string& name) const {
    const auto found = statuses_.find(name);
    return found == statuses_.end() ? "" : found->second;
  }
  bus_ros::RosNode& node() { return node_; }

 private:
  bus_ros::RosNode node_;
  bus_ros::RosReader<ros_messages::sensor_msgs::JointState> joint_states_ =
      node_.reader<ros_messages::sensor_msgs::JointState>("joint_states", {.depth = 100}).value();
  bus_ros::RosReader<ros_messages::rcl_interfaces::Log> log_ =
      node_.reader<ros_messages::rcl_interfaces::Log>("/rosout", {.transient_local = true, .depth = 1000}).value();
  bus_ros::RosReader<ros_messages::diagnostic_msgs::DiagnosticArray> diagnostics_ =
      node_.reader<ros_messages::diagnostic_msgs::DiagnosticArray>("/diagnostics", {.depth = 10}).value();
  std::map<std::string, double> angles_rad_;
  std::vector<std::string> lines_;
  std::map<std::string, std::string> statuses_;
};

}  // namespace farrier::test
