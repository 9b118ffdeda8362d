#pragma once

#include <set>
#include <string>
#include <vector>

#include "bus/network.hpp"
#include "tools/deploy/finding.hpp"

namespace farrier::deploy {

/// UDP ports that are bound on this computer (/proc/net/udp), as far as its network namespace shows.
std::set<int> bound_udp_ports();

/// Domains that DDS processes of this computer are in, by the pairs of ports each participant binds (RTPS 2.2, 9.6.1).
std::vector<int> domains_in_use(const std::set<int>& ports);

/// Ports that Linux hands out by itself, from /proc/sys/net/ipv4/ip_local_port_range.
struct PortRange {
  int first = 0;
  int last = -1;
};
PortRange ephemeral_ports();

/// Obstacles to another process in the domain: no index left for it, or ports that others may have by chance.
Findings port_findings(const bus::NetworkOptions& network, const std::set<int>& ports, PortRange ephemeral);

/// Reports the domains of DDS processes if the requested domain is empty.
Findings other_domain_findings(const bus::NetworkOptions& network, const std::set<int>& ports);

}  // namespace farrier::deploy
