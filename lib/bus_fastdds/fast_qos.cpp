#include "bus_fastdds/fast_qos.hpp"

#include <fastrtps/utils/IPLocator.h>

#include <algorithm>

namespace farrier::bus_fastdds {
namespace {

using namespace std::chrono_literals;
using eprosima::fastrtps::Duration_t;
using eprosima::fastrtps::rtps::IPLocator;
using eprosima::fastrtps::rtps::Locator_t;

// Announcements go by unicast to every port a process may have, so they are rare; a process that starts announces
// itself at once and everyone answers.
constexpr Nanoseconds kAnnouncementPeriod = 5s;
constexpr std::uint32_t kInitialAnnouncements = 5;
constexpr Nanoseconds kInitialAnnouncementPeriod = 20ms;

// Nothing waits for heartbeats while nothing is lost: readers greet the writers they find, and no KEEP_LAST writer
// waits for acknowledgements. So the period is the longest acceptable delay of a lost sample, and no sample carries a
// heartbeat. With a history of a few samples per key Fast DDS would add one to almost every sample, and an answer to
// each.
constexpr Nanoseconds kHeartbeatPeriod = 50ms;
constexpr Nanoseconds kFirstAcknowledgement = 5ms;
// Time after sending a sample in which requests for it are ignored. Fast DDS wakes its event thread twice per such time
// and reader, with zero for every sample, which costs more than the sample.
constexpr Nanoseconds kRequestsIgnored = 20ms;

// Far more keys than any topic has; only keys that are used take memory.
constexpr int kMaxKeys = 256;
constexpr int kFirstSamples = 32;  // allocated before the first write

Duration_t duration(Nanoseconds time) {
  if (time == bus::kInfinite) {
    return eprosima::fastrtps::c_TimeInfinite;
  }
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time);
  return Duration_t(static_cast<std::int32_t>(seconds.count()), static_cast<std::uint32_t>((time - seconds).count()));
}

Locator_t locator(const std::string& address) {
  Locator_t result;
  IPLocator::createLocator(LOCATOR_KIND_UDPv4, address, 0, result);  // port 0: the well-known one
  return result;
}

dds::PartitionQosPolicy partition_list(const std::vector<std::string>& partitions) {
  dds::PartitionQosPolicy policy;
  for (const std::string& partition : partitions) {
    policy.push_back(partition.c_str());
  }
  return policy;
}

void set_security(dds::DomainParticipantQos& qos, const bus::SecurityFiles& files) {
  const std::string auth = "dds.sec.auth.builtin.PKI-DH.";
  const std::string access = "dds.sec.access.builtin.Access-Permissions.";
  const std::pair<std::string, std::string> properties[] = {
      {"dds.sec.auth.plugin", "builtin.PKI-DH"},
      {auth + "identity_ca", "file://" + files.identity_ca},
      {auth + "identity_certificate", "file://" + files.certificate},
      {auth + "private_key", "file://" + files.private_key},
      {"dds.sec.access.plugin", "builtin.Access-Permissions"},
      {access + "permissions_ca", "file://" + files.permissions_ca},
      {access + "governance", "file://" + files.governance},
      {access + "permissions", "file://" + files.permissions},
      {"dds.sec.crypto.plugin", "builtin.AES-GCM-GMAC"}};
  for (const auto& [name, value] : properties) {
    qos.properties().properties().emplace_back(name, value);
  }
}

// Policies that writers and readers have in common.
template <class EndpointQos>
void set_common(EndpointQos& qos, const bus::EndpointSpec& endpoint) {
  const bus::Qos& wanted = endpoint.qos;
  qos.reliability().kind = wanted.reliability == bus::Reliability::kReliable ? dds::RELIABLE_RELIABILITY_QOS
                                                                             : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = wanted.durability == bus::Durability::kTransientLocal ? dds::TRANSIENT_LOCAL_DURABILITY_QOS
                                                                                : dds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = wanted.history_depth;
  qos.deadline().period = duration(wanted.deadline);
  qos.liveliness().kind = wanted.liveliness == bus::Liveliness::kManualByTopic ? dds::MANUAL_BY_TOPIC_LIVELINESS_QOS
                                                                               : dds::AUTOMATIC_LIVELINESS_QOS;
  qos.liveliness().lease_duration = duration(wanted.lease);
  qos.ownership().kind = wanted.ownership == bus::Ownership::kExclusive ? dds::EXCLUSIVE_OWNERSHIP_QOS
                                                                        : dds::SHARED_OWNERSHIP_QOS;
  // KEEP_LAST per key is the bound: no limit beside it may refuse or displace a sample.
  qos.resource_limits().max_samples = 0;
  qos.resource_limits().max_instances = kMaxKeys;
  qos.resource_limits().max_samples_per_instance = wanted.history_depth;
  qos.resource_limits().allocated_samples = kFirstSamples;
  qos.endpoint().history_memory_policy = endpoint.topic == bus::TopicId::kSystemJournal
                                             ? eprosima::fastrtps::rtps::DYNAMIC_REUSABLE_MEMORY_MODE  // of any size
                                             : eprosima::fastrtps::rtps::PREALLOCATED_MEMORY_MODE;
  qos.data_sharing().off();
}

}  // namespace

std::shared_ptr<FastTransportDescriptor> transport(const bus::NetworkOptions& options) {
  const auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {options.address};
  udp->sendBufferSize = bus::kSocketBufferBytes;
  udp->receiveBufferSize = bus::kSocketBufferBytes;
  udp->maxInitialPeersRange = static_cast<std::uint32_t>(options.max_processes);
  return std::make_shared<FastTransportDescriptor>(udp);
}

dds::DomainParticipantQos participant_qos(const bus::NetworkOptions& options, int index,
                                          std::shared_ptr<FastTransportDescriptor> transport) {
  dds::DomainParticipantQos qos;
  qos.name("farrier");
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports = {std::move(transport)};

  auto& wire = qos.wire_protocol();
  wire.default_unicast_locator_list.push_back(locator(options.address));
  wire.builtin.metatrafficUnicastLocatorList.push_back(locator(options.address));
  for (const std::string& peer : options.peers) {
    wire.builtin.initialPeersList.push_back(locator(peer));
  }
  wire.participant_id = index;
  // Another process may take the index's ports first. Then it tries the next ones, up to the last.
  wire.builtin.mutation_tries = static_cast<std::uint32_t>(options.max_processes - index);
  auto& discovery = wire.builtin.discovery_config;
  discovery.leaseDuration = duration(options.lease);
  discovery.leaseDuration_announcementperiod = duration(kAnnouncementPeriod);
  discovery.initial_announcements.count = kInitialAnnouncements;
  discovery.initial_announcements.period = duration(kInitialAnnouncementPeriod);
  if (options.security) {
    set_security(qos, *options.security);
  }
  return qos;
}

dds::PublisherQos publisher_qos(const std::vector<std::string>& partitions) {
  dds::PublisherQos qos;
  qos.partition() = partition_list(partitions);
  return qos;
}

dds::SubscriberQos subscriber_qos(const std::vector<std::string>& partitions) {
  dds::SubscriberQos qos;
  qos.partition() = partition_list(partitions);
  return qos;
}

dds::DataWriterQos writer_qos(const bus::EndpointSpec& endpoint, bool secured) {
  dds::DataWriterQos qos;
  set_common(qos, endpoint);
  // gathered_sends.hpp sends samples together, except encrypted messages. Only Fast DDS's thread for asynchronous
  // writers puts more than one sample into these. It tries a writer's lock repeatedly without sleeping, so the threads
  // that write must have its priority.
  const bool encrypted_together = secured && bus::spec(endpoint.topic).sending == bus::Sending::kTogether;
  qos.publish_mode().kind = encrypted_together ? dds::ASYNCHRONOUS_PUBLISH_MODE : dds::SYNCHRONOUS_PUBLISH_MODE;
  qos.ownership_strength().value = static_cast<std::uint32_t>(std::max(0, endpoint.ownership_strength));
  qos.writer_data_lifecycle().autodispose_unregistered_instances = false;
  if (endpoint.qos.lease != bus::kInfinite) {
    qos.liveliness().announcement_period = duration(endpoint.qos.lease / 3);  // AUTOMATIC: twice lost is not yet dead
  }
  qos.reliable_writer_qos().disable_heartbeat_piggyback = true;
  auto& times = qos.reliable_writer_qos().times;
  times.initialHeartbeatDelay = duration(0ms);
  times.heartbeatPeriod = duration(kHeartbeatPeriod);
  times.nackResponseDelay = duration(0ms);
  times.nackSupressionDuration = duration(kRequestsIgnored);
  return qos;
}

dds::DataReaderQos reader_qos(const bus::EndpointSpec& endpoint) {
  dds::DataReaderQos qos;
  set_common(qos, endpoint);
  auto& times = qos.reliable_reader_qos().times;
  times.initialAcknackDelay = duration(kFirstAcknowledgement);
  times.heartbeatResponseDelay = duration(0ms);
  return qos;
}

}  // namespace farrier::bus_fastdds
