#pragma once

#include <dds/dds.h>

#include <optional>
#include <string>
#include <vector>

#include "bus_ros/ros_endpoints.hpp"
#include "bus_ros/ros_network.hpp"

namespace farrier::bus_ros {

/// DDS topic of the graph message.
inline constexpr const char* kGraphTopic = "ros_discovery_info";

/// Graph endpoints of other nodes: Iron and later give the hash of the type, Humble has none.
struct GraphPeers {
  int with_hash = 0;
  int without_hash = 0;
};

/// The form in which the graph message is sent; kNone: in none. With kAuto it is that of the peers. Nodes of Humble that
/// get a message of Jazzy crash: where both are there, none is sent.
Graph acting_graph(Graph wanted, const GraphPeers& peers) noexcept;

/// Finds graph endpoints among all that Cyclone has discovered.
class GraphWatch {
 public:
  /// Readers of discovery, owned by `participant`.
  static Result<GraphWatch> create(dds_entity_t participant);
  GraphPeers peers() const;

 private:
  GraphWatch(Gid own, std::vector<dds_entity_t> readers) : own_(own), readers_(std::move(readers)) {}

  Gid own_;
  std::vector<dds_entity_t> readers_;
};

/// The message of a node: its name, readers and writers. `Gid` of Humble is filled up with zeros.
template <class Info, class Node, class GidMessage>
Info graph_message(const Gid& participant, const std::string& ns, const std::string& name,
                   const std::vector<Gid>& readers, const std::vector<Gid>& writers) {
  const auto message_of = [](const Gid& gid) {
    GidMessage message;
    std::copy(gid.begin(), gid.end(), message.data.begin());
    return message;
  };
  Info info;
  info.gid = message_of(participant);
  if (name.empty()) {
    return info;  // of a participant that leaves
  }
  Node node;
  node.node_namespace = ns;
  node.node_name = name;
  for (const Gid& gid : readers) {
    node.reader_gid_seq.push_back(message_of(gid));
  }
  for (const Gid& gid : writers) {
    node.writer_gid_seq.push_back(message_of(gid));
  }
  info.node_entities_info_seq.push_back(std::move(node));
  return info;
}

}  // namespace farrier::bus_ros
