#pragma once

#include <dds/dds.h>

#include <string>

#include "bus/network.hpp"
#include "core/result.hpp"

namespace farrier::bus_cyclone {

/// A domain with sockets of its own, whatever else this process has opened; deleting `entity` ends it with all in it.
struct Domain {
  dds_entity_t entity;
  dds_domainid_t number;  ///< Cyclone's own, by which its log tells domains of a process apart
};

/// What Cyclone refused, with its reason.
Error refused(const std::string& what, dds_return_t code);

/// Opens the domain of `options`. A user's CYCLONEDDS_URI is read after the settings made here.
Result<Domain> open_domain(const bus::NetworkOptions& options);

/// Joins it, secured as `options` says. Refuses, and ends the domain, where Cyclone does.
Result<dds_entity_t> join_domain(const Domain& domain, const bus::NetworkOptions& options);

}  // namespace farrier::bus_cyclone
