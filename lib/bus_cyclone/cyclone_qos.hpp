#pragma once

#include <dds/dds.h>

#include <optional>
#include <string>
#include <vector>

#include "bus/bus.hpp"
#include "bus/network.hpp"
#include "cyclone_base/cyclone_base.hpp"

namespace farrier::bus_cyclone {

using cyclone_base::QosPtr;

/// QoS of a participant: DDS Security as the files say, or none.
QosPtr participant_qos(const std::optional<bus::SecurityFiles>& security);

/// QoS of a publisher or subscriber that carries the partitions of its endpoints.
QosPtr partition_qos(const std::vector<std::string>& partitions);

/// QoS of a writer or reader. Cyclone ignores policies that the endpoint's kind does not have.
QosPtr endpoint_qos(const bus::EndpointSpec& endpoint);

}  // namespace farrier::bus_cyclone
