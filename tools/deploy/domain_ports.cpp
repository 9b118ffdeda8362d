#include "tools/deploy/domain_ports.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace farrier::deploy {
namespace {

// RTPS 2.2, 9.6.1.1: PB, DG, PG, d1, d3.
constexpr int kPortBase = 7400;
constexpr int kDomainGain = 250;
constexpr int kIndexGain = 2;
constexpr int kDiscoveryOffset = 10;
constexpr int kDataOffset = 11;
constexpr int kLastDomain = 232;

int first_port(int domain) { return kPortBase + kDomainGain * domain; }

bool index_is_taken(const std::set<int>& ports, int domain, int index) {
  const int port = first_port(domain) + kIndexGain * index;
  return ports.contains(port + kDiscoveryOffset) && ports.contains(port + kDataOffset);
}

}  // namespace

std::set<int> bound_udp_ports() {
  std::set<int> ports;
  std::ifstream table("/proc/net/udp");
  std::string line;
  std::getline(table, line);  // its heading
  while (std::getline(table, line)) {
    std::istringstream words(line);
    std::string slot, local;
    words >> slot >> local;  // "0100007F:1D0A", both hexadecimal
    if (const auto colon = local.find(':'); colon != std::string::npos) {
      ports.insert(static_cast<int>(std::strtol(local.c_str() + colon + 1, nullptr, 16)));
    }
  }
  return ports;
}

std::vector<int> domains_in_use(const std::set<int>& ports) {
  std::vector<int> domains;
  for (int domain = 0; domain <= kLastDomain; ++domain) {
    for (int index = 0; kDataOffset + kIndexGain * index < kDomainGain; ++index) {
      if (index_is_taken(ports, domain, index)) {
        domains.push_back(domain);
        break;
      }
    }
  }
  return domains;
}

PortRange ephemeral_ports() {
  PortRange range;
  std::ifstream("/proc/sys/net/ipv4/ip_local_port_range") >> range.first >> range.last;
  return range;
}

Findings port_findings(const bus::NetworkOptions& network, const std::set<int>& ports, PortRange ephemeral) {
  Findings findings;
  int taken = 0;
  for (int index = 0; index < network.max_processes; ++index) {
    taken += index_is_taken(ports, network.domain, index) ? 1 : 0;
  }
  if (taken == network.max_processes) {
    findings.push_back({"all " + std::to_string(taken) + " participant indexes of domain " +
                            std::to_string(network.domain) + " are taken on this computer: no process can join",
                        "end processes that are left over (ss -ulpn shows them), or let joint_nodes host more joints"});
  }
  const int first = first_port(network.domain);
  const int last = first + kDataOffset + kIndexGain * (network.max_processes - 1);
  if (first <= ephemeral.last && last >= ephemeral.first) {
    findings.push_back({"ports " + std::to_string(first) + " to " + std::to_string(last) + " of domain " +
                            std::to_string(network.domain) + " are among those Linux hands out by itself, " +
                            std::to_string(ephemeral.first) + " to " + std::to_string(ephemeral.last) +
                            ": any program may have one",
                        "take a domain from 0 to 100"});
  }
  return findings;
}

Findings other_domain_findings(const bus::NetworkOptions& network, const std::set<int>& ports) {
  std::string list;
  for (const int domain : domains_in_use(ports)) {
    if (domain != network.domain) {
      list += (list.empty() ? "" : ", ") + std::to_string(domain);
    }
  }
  if (list.empty()) {
    return {};
  }
  return {{"DDS processes of this computer are in domain " + list + ", not in " + std::to_string(network.domain),
           "ask with --domain " + list.substr(0, list.find(',')) + ", or give the robot's processes domain " +
               std::to_string(network.domain)}};
}

}  // namespace farrier::deploy
