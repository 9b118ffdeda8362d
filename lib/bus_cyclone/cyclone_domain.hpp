#pragma once

#include <dds/dds.h>

#include <string>

#include "bus/network.hpp"
#include "core/result.hpp"
#include "cyclone_base/cyclone_base.hpp"

namespace farrier::bus_cyclone {

/// A domain with sockets of its own, whatever else this process has opened; deleting `entity` ends the domain.
struct Domain {
  dds_entity_t entity;
  dds_domainid_t number;  ///< Cyclone's own, by which its log distinguishes domains of a process
};

using cyclone_base::refused;

/// Opens the domain of `options`. The settings of a user's CYCLONEDDS_URI that bus::cyclone_settings honours are read after
/// those made here. If Cyclone refuses them, they are set aside, which is said on stderr.
Result<Domain> open_domain(const bus::NetworkOptions& options);

/// Joins it, secured as `options` says. If Cyclone refuses, it ends the domain and refuses, too.
Result<dds_entity_t> join_domain(const Domain& domain, const bus::NetworkOptions& options);

}  // namespace farrier::bus_cyclone
