#include "bus_cyclone/cyclone_clocks.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "bus/topics.hpp"
#include "bus_cyclone/cyclone_endpoints.hpp"
#include "bus_cyclone/cyclone_qos.hpp"

namespace farrier::bus_cyclone {
namespace {

/// Longest delay between a sample's arrival and its reading.
constexpr dds_duration_t kLookEvery = DDS_MSECS(1);

/// GUID prefix of the writer of a sample; empty if it has gone since.
std::string writer_of(dds_entity_t reader, dds_instance_handle_t publication) {
  dds_builtintopic_endpoint_t* const endpoint = dds_get_matched_publication_data(reader, publication);
  if (endpoint == nullptr) {
    return {};
  }
  std::string prefix = cyclone_base::prefix_text(endpoint->participant_key);
  dds_builtintopic_free_endpoint(endpoint);
  return prefix;
}

}  // namespace

std::vector<bus::DiscoveredClock> compare_clocks(dds_entity_t participant, Nanoseconds how_long) {
  bus::EndpointSpec endpoint{.topic = bus::TopicId::kSystemHealth, .qos = {}, .partitions = {"*"}};
  endpoint.qos.reliability = bus::Reliability::kBestEffort;
  const dds_entity_t topic = dds_create_topic(participant, &topic_descriptor(endpoint.topic),
                                              bus::spec(endpoint.topic).name, nullptr, nullptr);
  const dds_entity_t subscriber = dds_create_subscriber(participant, partition_qos(endpoint.partitions).get(), nullptr);
  const dds_entity_t reader = dds_create_reader(subscriber, topic, endpoint_qos(endpoint).get(), nullptr);
  std::map<std::string, dds_duration_t> ahead;
  const dds_time_t end = dds_time() + how_long.count();
  for (dds_time_t now = dds_time(); now < end; now = dds_time()) {
    void* sample[1] = {};
    dds_sample_info_t info[1];
    while (dds_take(reader, sample, info, 1, 1) > 0) {
      const std::string writer = writer_of(reader, info->publication_handle);
      if (info->valid_data && !writer.empty()) {
        const dds_duration_t seen = info->source_timestamp - now;
        const auto most = ahead.try_emplace(writer, seen).first;
        most->second = std::max(most->second, seen);
      }
      dds_return_loan(reader, sample, 1);
    }
    dds_sleepfor(std::min(kLookEvery, end - now));
  }
  std::vector<bus::DiscoveredClock> clocks;
  for (const auto& [writer, most] : ahead) {
    clocks.push_back({writer, Nanoseconds(most)});
  }
  return clocks;
}

}  // namespace farrier::bus_cyclone
