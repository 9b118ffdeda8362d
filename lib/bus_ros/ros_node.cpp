#include "bus_ros/ros_node.hpp"

#include <utility>

#include "bus_ros/cyclone_ros_endpoints.hpp"
#include "bus_ros/graph.hpp"
#include "bus_ros/ros_domain.hpp"
#include "ros_messages/cdr.hpp"
#include "ros_messages/names.hpp"

namespace farrier::bus_ros {

using JazzyInfo = ros_messages::rmw_dds_common::ParticipantEntitiesInfo;
using HumbleInfo = ros_messages::rmw_dds_common_humble::ParticipantEntitiesInfo;

namespace {

constexpr RosQos kGraphQos{.reliable = true, .transient_local = true, .depth = 1};

std::string hash_text(const std::string& hash) { return "typehash=" + hash + ";"; }

std::vector<std::uint8_t> graph_bytes(Graph form, const Gid& participant, const std::string& ns,
                                      const std::string& name, const std::vector<Gid>& readers,
                                      const std::vector<Gid>& writers) {
  std::vector<std::uint8_t> bytes;
  if (form == Graph::kHumble) {
    namespace humble = ros_messages::rmw_dds_common_humble;
    ros_messages::to_cdr(
        graph_message<HumbleInfo, humble::NodeEntitiesInfo, humble::Gid>(participant, ns, name, readers, writers),
        bytes);
  } else {
    namespace jazzy = ros_messages::rmw_dds_common;
    ros_messages::to_cdr(
        graph_message<JazzyInfo, jazzy::NodeEntitiesInfo, jazzy::Gid>(participant, ns, name, readers, writers), bytes);
  }
  return bytes;
}

}  // namespace

struct RosNode::Parts {
  Parts(Options of_node, dds_entity_t of_domain, dds_entity_t of_participant, GraphWatch of_graph)
      : options(std::move(of_node)), domain(of_domain), participant(of_participant), watch(std::move(of_graph)) {}
  ~Parts() {
    publish_graph("");
    graph_writer.reset();
    dds_delete(domain);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void publish_graph(const std::string& name) {
    if (graph_writer != nullptr) {
      graph_writer->write(graph_bytes(acting, gid_of(participant), options.ros_namespace, name, readers, writers));
    }
  }

  /// Ends the writer of the graph message and opens that of another form.
  Result<Done> change_graph(Graph form) {
    publish_graph("");
    graph_writer.reset();
    acting = form;
    if (form != Graph::kNone) {
      const bool humble = form == Graph::kHumble;
      graph_writer =
          FARRIER_TRY(open_writer(participant, kGraphTopic, humble ? HumbleInfo::kRosName : JazzyInfo::kRosName,
                                  kGraphQos, humble ? "" : hash_text(ros_messages::type_hash<JazzyInfo>())));
      publish_graph(options.name);
    }
    return Done{};
  }

  Options options;
  dds_entity_t domain;
  dds_entity_t participant;
  GraphWatch watch;
  Graph acting = Graph::kNone;
  bool mixed = false;
  std::shared_ptr<RawRosWriter> graph_writer;
  std::vector<Gid> readers, writers;
};

RosNode::RosNode(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
RosNode::RosNode(RosNode&&) noexcept = default;
RosNode& RosNode::operator=(RosNode&&) noexcept = default;
RosNode::~RosNode() = default;

Result<RosNode> RosNode::create(const Options& options) {
  const dds_entity_t domain = FARRIER_TRY(open_ros_domain(options.network));
  const dds_entity_t participant = FARRIER_TRY(join_ros_domain(domain));
  auto watch = GraphWatch::create(participant);
  if (!watch) {
    dds_delete(domain);
    return watch.error();
  }
  RosNode node(std::make_unique<Parts>(options, domain, participant, std::move(watch).value()));
  if (options.graph != Graph::kAuto) {
    FARRIER_TRY(node.parts_->change_graph(options.graph));
  }
  return node;
}

std::string RosNode::full_name(const std::string& topic) const {
  return ros_messages::full_name(parts_->options.ros_namespace, topic);
}

Graph RosNode::acting_graph() const noexcept { return parts_->acting; }

Result<std::shared_ptr<RawRosWriter>> RosNode::open_raw_writer(const std::string& topic, const char* type,
                                                               const std::string& hash, const RosQos& qos) {
  auto raw = FARRIER_TRY(open_writer(parts_->participant, "rt" + full_name(topic), type, qos, hash_text(hash)));
  parts_->writers.push_back(raw->gid());
  parts_->publish_graph(parts_->options.name);
  return raw;
}

Result<std::shared_ptr<RawRosReader>> RosNode::open_raw_reader(const std::string& topic, const char* type,
                                                               const std::string& hash, const RosQos& qos) {
  auto raw = FARRIER_TRY(open_reader(parts_->participant, "rt" + full_name(topic), type, qos, hash_text(hash)));
  parts_->readers.push_back(raw->gid());
  parts_->publish_graph(parts_->options.name);
  return raw;
}

std::string RosNode::look() {
  const GraphPeers peers = parts_->watch.peers();
  const bool mixed = peers.with_hash > 0 && peers.without_hash > 0;
  const bool becomes_mixed = mixed && !parts_->mixed;
  parts_->mixed = mixed;
  const Graph form = bus_ros::acting_graph(parts_->options.graph, peers);
  if (form != parts_->acting) {
    if (auto changed = parts_->change_graph(form); !changed) {
      return changed.error().message;
    }
    if (!mixed && form != Graph::kNone) {
      return std::string("this node has its name for nodes of ") +
             (form == Graph::kHumble ? "Humble" : "Iron and later");
    }
  }
  return becomes_mixed
             ? "nodes of Humble and of a later ROS 2 share this domain: this node has no name, its topics work; "
               "give them domains of their own"
             : "";
}

}  // namespace farrier::bus_ros
