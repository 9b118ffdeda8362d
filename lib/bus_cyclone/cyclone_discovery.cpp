#include "bus_cyclone/cyclone_discovery.hpp"

#include <algorithm>
#include <array>

#include "bus_cyclone/cyclone_clocks.hpp"
#include "bus_cyclone/cyclone_domain.hpp"

namespace farrier::bus_cyclone {
namespace {

constexpr std::size_t kSamplesAtOnce = 64;

Nanoseconds time_of(dds_duration_t duration) { return Nanoseconds(duration); }

bus::Qos qos_of(const dds_qos_t* announced) {
  bus::Qos qos;
  dds_reliability_kind_t reliability = DDS_RELIABILITY_BEST_EFFORT;
  dds_duration_t time = DDS_INFINITY;
  dds_qget_reliability(announced, &reliability, &time);
  qos.reliability =
      reliability == DDS_RELIABILITY_RELIABLE ? bus::Reliability::kReliable : bus::Reliability::kBestEffort;
  dds_durability_kind_t durability = DDS_DURABILITY_VOLATILE;
  dds_qget_durability(announced, &durability);
  // Transient and persistent offer more than transient local, which is what is asked for here.
  qos.durability =
      durability == DDS_DURABILITY_VOLATILE ? bus::Durability::kVolatile : bus::Durability::kTransientLocal;
  time = DDS_INFINITY;
  dds_qget_deadline(announced, &time);
  qos.deadline = time_of(time);
  dds_liveliness_kind_t liveliness = DDS_LIVELINESS_AUTOMATIC;
  time = DDS_INFINITY;
  dds_qget_liveliness(announced, &liveliness, &time);
  qos.liveliness =
      liveliness == DDS_LIVELINESS_AUTOMATIC ? bus::Liveliness::kAutomatic : bus::Liveliness::kManualByTopic;
  qos.lease = time_of(time);
  dds_ownership_kind_t ownership = DDS_OWNERSHIP_SHARED;
  dds_qget_ownership(announced, &ownership);
  qos.ownership = ownership == DDS_OWNERSHIP_EXCLUSIVE ? bus::Ownership::kExclusive : bus::Ownership::kShared;
  return qos;
}

std::vector<std::string> partitions_of(const dds_qos_t* announced) {
  std::uint32_t count = 0;
  char** names = nullptr;
  std::vector<std::string> partitions;
  if (dds_qget_partition(announced, &count, &names)) {
    for (std::uint32_t i = 0; i < count; ++i) {
      partitions.emplace_back(names[i]);
      dds_free(names[i]);
    }
    dds_free(names);
  }
  return partitions;
}

bus::DiscoveredEndpoint endpoint_of(const dds_builtintopic_endpoint_t& announced, bool writes) {
  bus::DiscoveredEndpoint endpoint{.writes = writes,
                                   .participant = cyclone_base::prefix_text(announced.participant_key),
                                   .topic = announced.topic_name,
                                   .type = announced.type_name,
                                   .qos = qos_of(announced.qos),
                                   .partitions = partitions_of(announced.qos),
                                   .ownership_strength = 0};
  dds_qget_ownership_strength(announced.qos, &endpoint.ownership_strength);
  return endpoint;
}

/// Calls use(sample) for everything alive on a builtin topic.
template <class Sample, class Use>
void for_each_alive(dds_entity_t participant, dds_entity_t topic, Use use) {
  const dds_entity_t reader = dds_create_reader(participant, topic, nullptr, nullptr);
  std::array<void*, kSamplesAtOnce> samples{};
  std::array<dds_sample_info_t, kSamplesAtOnce> infos;
  for (dds_return_t count = 1; count > 0;) {
    count = dds_take(reader, samples.data(), infos.data(), samples.size(), samples.size());
    for (dds_return_t i = 0; i < count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (infos[at].valid_data && infos[at].instance_state == DDS_ALIVE_INSTANCE_STATE) {
        use(*static_cast<const Sample*>(samples[at]));
      }
    }
    if (count > 0) {
      dds_return_loan(reader, samples.data(), count);
    }
  }
  dds_delete(reader);
}

}  // namespace

Result<bus::Discovery> discover(const bus::NetworkOptions& options, Nanoseconds how_long) {
  const auto domain = FARRIER_TRY(open_domain(options));
  const auto joined = FARRIER_TRY(join_domain(domain, options));
  const dds_entity_t participant = joined;
  dds_guid_t self{};
  dds_get_guid(participant, &self);
  const std::string own = cyclone_base::prefix_text(self);
  bus::Discovery found;
  found.clocks = compare_clocks(participant, how_long);
  for_each_alive<dds_builtintopic_participant_t>(participant, DDS_BUILTIN_TOPIC_DCPSPARTICIPANT, [&](const auto& p) {
    if (cyclone_base::prefix_text(p.key) != own) {
      found.participants.push_back(cyclone_base::prefix_text(p.key));
    }
  });
  for (const bool writes : {true, false}) {
    const dds_entity_t topic = writes ? DDS_BUILTIN_TOPIC_DCPSPUBLICATION : DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION;
    for_each_alive<dds_builtintopic_endpoint_t>(participant, topic, [&](const auto& endpoint) {
      if (cyclone_base::prefix_text(endpoint.participant_key) != own) {
        found.endpoints.push_back(endpoint_of(endpoint, writes));
      }
    });
  }
  dds_delete(domain.entity);
  return found;
}

}  // namespace farrier::bus_cyclone
