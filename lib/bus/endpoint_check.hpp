#pragma once

#include <optional>
#include <string>

#include "bus/bus.hpp"
#include "bus/network.hpp"
#include "core/result.hpp"

namespace farrier::bus {

/// Why no bus can honour an endpoint, if so. Each vendor adds what it alone cannot.
inline std::optional<Error> endpoint_error(const EndpointSpec& endpoint) {
  const std::string where = std::string(spec(endpoint.topic).name) + ": ";
  if (endpoint.qos.history_depth < 1) {
    return Error{where + "history_depth " + std::to_string(endpoint.qos.history_depth) + " must be at least 1"};
  }
  if (endpoint.qos.deadline <= Nanoseconds::zero() || endpoint.qos.lease <= Nanoseconds::zero()) {
    return Error{where + "deadline and liveliness lease must be positive; infinite means none"};
  }
  for (const std::string& partition : endpoint.partitions) {
    if (partition.find_first_of("*?[]") != std::string::npos) {
      return Error{where + "partition '" + partition + "' holds a wildcard; partitions are exact names"};
    }
  }
  return std::nullopt;
}

/// Where to look when a vendor refuses an endpoint, which it does without saying why.
inline std::string refusals_by(const NetworkOptions& options) {
  return options.security ? " (do the permissions beside " + options.security->certificate + " allow it?)" : "";
}

}  // namespace farrier::bus
