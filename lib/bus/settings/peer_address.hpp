#pragma once

#include <string>

#include "bus/network.hpp"
#include "core/result.hpp"

namespace farrier::bus {

/// Refuses an address of this computer that is no IPv4 address, which is the kind that DDS uses here.
Result<Done> check_address(const std::string& address);

/// IPv4 address of a computer, by address or by a name that resolves. Refuses others, with the remedy.
Result<std::string> resolve_peer(const std::string& peer);

/// Returns the error of such an address or peer of a command line; empty for none.
std::string address_error(const std::string& address);
std::string peer_error(const std::string& peer);

/// The same network with the peers' addresses; refuses as the above. It may wait for a name server.
Result<NetworkOptions> resolve(NetworkOptions network);

}  // namespace farrier::bus
