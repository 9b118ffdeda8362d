#pragma once

// The bus over Eclipse Cyclone DDS 0.10: UDP only, unicast on one interface, data handled on one receive thread.

#include <memory>

#include "bus/bus.hpp"
#include "bus/network.hpp"
#include "core/result.hpp"

namespace farrier::bus_cyclone {

/// Joins the DDS domain of `options` as one participant with sockets of its own, also when the process already
/// holds another bus of this domain.
///
/// A user's CYCLONEDDS_URI is read after the settings made here, but for what it says of interfaces, discovery, message
/// sizes and the like (bus/settings/user_settings.hpp). It changes only what it names:
///   CYCLONEDDS_URI='<Domain Id="any"><Tracing><Verbosity>config</Verbosity></Tracing></Domain>'
///
/// Arrivals are counted on the receive thread, once per sample. The end of a writer, which every key it wrote reports,
/// may count as one more.
Result<std::unique_ptr<bus::Bus>> create_cyclone_bus(const bus::NetworkOptions& options);

}  // namespace farrier::bus_cyclone
