#pragma once

#include <memory>

#include "bus/bus.hpp"
#include "bus_fastdds/fast_session.hpp"

namespace farrier::bus_fastdds {

Result<std::unique_ptr<bus::RawWriter>> make_writer(const std::shared_ptr<FastSession>& session,
                                                    const bus::EndpointSpec& endpoint);

/// Counts the arrivals of the reader in `notifier`, if that is not null.
Result<std::unique_ptr<bus::RawReader>> make_reader(const std::shared_ptr<FastSession>& session,
                                                    const bus::EndpointSpec& endpoint,
                                                    std::shared_ptr<bus::Notifier> notifier);

}  // namespace farrier::bus_fastdds
