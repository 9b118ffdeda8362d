#pragma once

#include <dds/dds.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bus/bus.hpp"
#include "bus/network.hpp"

namespace farrier::bus_cyclone {

struct QosDeleter {
  void operator()(dds_qos_t* qos) const noexcept { dds_delete_qos(qos); }
};
using QosPtr = std::unique_ptr<dds_qos_t, QosDeleter>;

/// QoS of a participant: DDS Security as the files say, or none.
QosPtr participant_qos(const std::optional<bus::SecurityFiles>& security);

/// QoS of a publisher or subscriber that carries the partitions of its endpoints.
QosPtr partition_qos(const std::vector<std::string>& partitions);

/// QoS of a writer or reader. Cyclone ignores policies that the endpoint's kind does not have.
QosPtr endpoint_qos(const bus::EndpointSpec& endpoint);

}  // namespace farrier::bus_cyclone
