#pragma once

#include <dds/dds.h>

#include "bus/network.hpp"
#include "core/result.hpp"

namespace farrier::bus_cyclone {

/// A domain that one participant joined; deleting `domain` ends both.
struct JoinedDomain {
  dds_entity_t domain;
  dds_entity_t participant;
};

/// Joins the domain of `options` with sockets of its own, whatever this process has joined already. A user's
/// CYCLONEDDS_URI is read after the settings made here.
Result<JoinedDomain> join_domain(const bus::NetworkOptions& options);

}  // namespace farrier::bus_cyclone
