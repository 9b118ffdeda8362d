#pragma once

#include <memory>

#include "core/result.hpp"
#include "tools/monitor/display.hpp"
#include "tools/monitor/listen_address.hpp"
#include "robot/robot.hpp"

namespace farrier::display {

/// Serves the metrics of docs/metrics.md at http://<address>/metrics, on threads of its own. Refuses an address that
/// cannot be had. `robot` must outlive it.
Result<std::unique_ptr<Display>> expose_to_prometheus(const ListenAddress& address, const robot::Robot& robot);

}  // namespace farrier::display
