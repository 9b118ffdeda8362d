#include "bus_ros/graph.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "bus_ros/cyclone_ros_endpoints.hpp"
#include "cyclone_base/cyclone_base.hpp"

namespace farrier::bus_ros {
namespace {

bool same_participant(const dds_guid_t& guid, const Gid& gid) {
  return std::equal(gid.begin(), gid.begin() + cyclone_base::kPrefixBytes, std::begin(guid.v));
}

bool has_hash(const dds_qos_t* qos) {
  void* data = nullptr;
  std::size_t size = 0;
  if (!dds_qget_userdata(qos, &data, &size) || data == nullptr) {
    return false;
  }
  const bool found = std::string_view(static_cast<const char*>(data), size).find("typehash=") != std::string_view::npos;
  dds_free(data);
  return found;
}

}  // namespace

Graph acting_graph(Graph wanted, const GraphPeers& peers) noexcept {
  if (wanted != Graph::kAuto) {
    return wanted;
  }
  if (peers.with_hash > 0 && peers.without_hash > 0) {
    return Graph::kNone;
  }
  return peers.with_hash > 0 ? Graph::kJazzy : peers.without_hash > 0 ? Graph::kHumble : Graph::kNone;
}

Result<GraphWatch> GraphWatch::create(dds_entity_t participant) {
  std::vector<dds_entity_t> readers;
  for (const dds_entity_t topic : {DDS_BUILTIN_TOPIC_DCPSPUBLICATION, DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION}) {
    const dds_entity_t reader = dds_create_reader(participant, topic, nullptr, nullptr);
    if (reader < 0) {
      return cyclone_base::refused("a reader of discovery", reader);
    }
    readers.push_back(reader);
  }
  return GraphWatch(gid_of(participant), std::move(readers));
}

GraphPeers GraphWatch::peers() const {
  constexpr std::uint32_t kMost = 512;
  GraphPeers found;
  std::vector<void*> samples(kMost, nullptr);
  std::vector<dds_sample_info_t> infos(kMost);
  for (const dds_entity_t reader : readers_) {
    samples[0] = nullptr;
    const dds_return_t count = dds_read(reader, samples.data(), infos.data(), kMost, kMost);
    for (dds_return_t i = 0; i < count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const auto& endpoint = *static_cast<const dds_builtintopic_endpoint_t*>(samples[at]);
      if (infos[at].valid_data && infos[at].instance_state == DDS_ALIVE_INSTANCE_STATE &&
          std::string_view(endpoint.topic_name) == kGraphTopic && !same_participant(endpoint.participant_key, own_)) {
        ++(has_hash(endpoint.qos) ? found.with_hash : found.without_hash);
      }
    }
    if (count > 0) {
      dds_return_loan(reader, samples.data(), count);
    }
  }
  return found;
}

}  // namespace farrier::bus_ros
