#pragma once

#include <string>
#include <vector>

#include "bus/qos.hpp"

namespace farrier::bus {

/// A writer or reader of another process, as DDS discovery announces it. Policies that this stack does not use stay at
/// their defaults.
struct DiscoveredEndpoint {
  bool writes = false;
  std::string participant;  ///< its GUID prefix in hexadecimal digits; the first four are the vendor's
  std::string topic;
  std::string type;
  Qos qos;
  std::vector<std::string> partitions;  ///< empty: the default one
  int ownership_strength = 0;
};

/// The wall clock of a process, with which DDS stamps its samples.
struct DiscoveredClock {
  std::string participant;  ///< GUID prefix
  Nanoseconds ahead;        ///< compared to the clock here, less the transport time of its quickest sample
};

/// Participants and endpoints in a domain.
struct Discovery {
  std::vector<std::string> participants;  ///< GUID prefixes of all but this process
  std::vector<DiscoveredEndpoint> endpoints;
  std::vector<DiscoveredClock> clocks{};  ///< of those that reported their health meanwhile
};

}  // namespace farrier::bus
