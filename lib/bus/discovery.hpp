#pragma once

#include <string>
#include <vector>

#include "bus/qos.hpp"

namespace farrier::bus {

/// A writer or reader of somebody else's, as DDS discovery announces it. What a policy is that this stack does not use
/// stays at its default.
struct DiscoveredEndpoint {
  bool writes = false;
  std::string participant;  ///< its GUID prefix in hexadecimal digits; the first four are the vendor's
  std::string topic;
  std::string type;
  Qos qos;
  std::vector<std::string> partitions;  ///< empty: the default one
  int ownership_strength = 0;
};

/// The clock of day where a process runs, which DDS stamps its samples with.
struct DiscoveredClock {
  std::string participant;  ///< GUID prefix
  Nanoseconds ahead;        ///< of the clock here, less what its quickest sample was on its way
};

/// Who and what is in a domain.
struct Discovery {
  std::vector<std::string> participants;  ///< GUID prefixes of all but the one that looks
  std::vector<DiscoveredEndpoint> endpoints;
  std::vector<DiscoveredClock> clocks{};  ///< of those that reported their health meanwhile
};

}  // namespace farrier::bus
