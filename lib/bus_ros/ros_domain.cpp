#include "bus_ros/ros_domain.hpp"

#include <cstring>

namespace farrier::bus_ros {
namespace {

// Cyclone's own number of the domain, which differs from those of any other bus of this process.
constexpr dds_domainid_t kLocalNumbers = 500'000;
constexpr dds_domainid_t kMostOfAProcess = 64;

// rmw_cyclonedds looks for at most so many nodes on a computer that has no multicast.
constexpr const char* kMaxIndex = "32";

std::string element(const std::string& name, const std::string& content) {
  return '<' + name + '>' + content + "</" + name + '>';
}

}  // namespace

std::string ros_config(const Network& network) {
  const bool multicast = network.discovery == Discovery::kSubnet;
  std::string peers = multicast ? "" : "<Peer Address=\"127.0.0.1\"/>";
  for (const std::string& peer : network.peers) {
    peers += "<Peer Address=\"" + peer + "\"/>";
  }
  const std::string interface = network.address.empty() ? "<NetworkInterface autodetermine=\"true\"/>"
                                                        : "<NetworkInterface address=\"" + network.address + "\"/>";
  const std::string general = element("Interfaces", interface) +
                              element("AllowMulticast", multicast ? "true" : "false") + element("Transport", "udp");
  const std::string discovery = element("ExternalDomainId", std::to_string(network.domain)) +
                                element("ParticipantIndex", "auto") + element("MaxAutoParticipantIndex", kMaxIndex) +
                                (peers.empty() ? "" : element("Peers", peers));
  return element("CycloneDDS",
                 "<Domain Id=\"any\">" + element("General", general) + element("Discovery", discovery) + "</Domain>");
}

Error refused_by_cyclone(const std::string& what, dds_return_t code) {
  return Error{"Cyclone refuses " + what + ": " + dds_strretcode(code)};
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
    return refused_by_cyclone("ROS domain " + std::to_string(network.domain) + " (its own message is above)", domain);
  }
  return domain;
}

Result<dds_entity_t> join_ros_domain(dds_entity_t domain) {
  dds_domainid_t number = 0;
  dds_get_domainid(domain, &number);
  dds_qos_t* const qos = dds_create_qos();
  constexpr const char* kEnclave = "enclave=/;";
  dds_qset_userdata(qos, kEnclave, std::strlen(kEnclave));
  const dds_entity_t participant = dds_create_participant(number, qos, nullptr);
  dds_delete_qos(qos);
  if (participant < 0) {
    dds_delete(domain);
    return refused_by_cyclone("a participant of the ROS domain", participant);
  }
  return participant;
}

}  // namespace farrier::bus_ros
