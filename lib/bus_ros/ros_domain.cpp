#include "bus_ros/ros_domain.hpp"

#include <unistd.h>

#include <array>
#include <cstring>

#include "cyclone_base/cyclone_base.hpp"

namespace farrier::bus_ros {
namespace {

using cyclone_base::element;

constexpr const char* kLoopback = "127.0.0.1";

// Cyclone's own number of the domain, which differs from those of any other bus of this process.
constexpr dds_domainid_t kLocalNumbers = 500'000;
constexpr dds_domainid_t kMostOfAProcess = 64;

// rmw_cyclonedds looks for at most so many nodes on a computer that has no multicast.
constexpr const char* kMaxIndex = "32";

// Without multicast nobody hears a node of Fast DDS that has just started: it learns of us by the next announcement.
constexpr const char* kUnicastInterval = "1 s";

}  // namespace

std::string ros_config(const Network& network) {
  const bool multicast = network.discovery == Discovery::kSubnet;
  const bool off = network.discovery == Discovery::kOff;
  const std::string peers =
      off ? ""
          : (multicast ? "" : cyclone_base::peer_elements(std::array<std::string, 1>{kLoopback})) +
                cyclone_base::peer_elements(network.peers);
  const std::string interface = network.address.empty() ? "<NetworkInterface autodetermine=\"true\"/>"
                                                        : "<NetworkInterface address=\"" + network.address + "\"/>";
  const std::string general = element("Interfaces", interface) +
                              element("AllowMulticast", multicast ? "true" : "false") + element("Transport", "udp");
  // Participants of other tags do not see each other.
  const std::string tag = off ? element("Tag", "ros_discovery_off_" + std::to_string(::getpid())) : "";
  const std::string interval = multicast ? "" : element("SPDPInterval", kUnicastInterval);
  const std::string discovery = tag + interval + element("ExternalDomainId", std::to_string(network.domain)) +
                                element("ParticipantIndex", "auto") + element("MaxAutoParticipantIndex", kMaxIndex) +
                                (peers.empty() ? "" : element("Peers", peers));
  return element("CycloneDDS",
                 "<Domain Id=\"any\">" + element("General", general) + element("Discovery", discovery) + "</Domain>");
}

Result<dds_entity_t> open_ros_domain(const Network& network) {
  constexpr int kMaxDomain = 232;
  if (network.domain < 0 || network.domain > kMaxDomain) {
    return Error{"ROS domain " + std::to_string(network.domain) + " is outside 0.." + std::to_string(kMaxDomain)};
  }
  const std::string config = ros_config(network);
  dds_entity_t domain = DDS_RETCODE_PRECONDITION_NOT_MET;
  for (dds_domainid_t i = 0; i < kMostOfAProcess && domain == DDS_RETCODE_PRECONDITION_NOT_MET; ++i) {
    domain = dds_create_domain(kLocalNumbers + i, config.c_str());
  }
  if (domain < 0) {
    return cyclone_base::refused("ROS domain " + std::to_string(network.domain) + " (its own message is above)",
                                 domain);
  }
  return domain;
}

Result<dds_entity_t> join_ros_domain(dds_entity_t domain) {
  dds_domainid_t number = 0;
  dds_get_domainid(domain, &number);
  const cyclone_base::QosPtr qos(dds_create_qos());
  constexpr const char* kEnclave = "enclave=/;";
  dds_qset_userdata(qos.get(), kEnclave, std::strlen(kEnclave));
  const dds_entity_t participant = dds_create_participant(number, qos.get(), nullptr);
  if (participant < 0) {
    dds_delete(domain);
    return cyclone_base::refused("a participant of the ROS domain", participant);
  }
  return participant;
}

}  // namespace farrier::bus_ros
