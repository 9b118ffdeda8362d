#pragma once

#include <optional>
#include <string>

#include "core/fault.hpp"
#include "core/time.hpp"

namespace farrier::joint_node {

/// Turns a joint's faults, tick by tick, into the sentences of events: one for every change, with its cause. A clamped
/// reference may come and go with the signal: it counts as present until it has been absent for a while. A saturated
/// valve is part of control and no event.
class FaultEvents {
 public:
  /// "sensors stale", "sensors stale, command stale" or the message of a recovery; empty while nothing changes.
  std::optional<std::string> update(Tick tick, FaultSet faults);

 private:
  FaultSet reported_;
  Tick last_clamped_ = kNoTick;
};

}  // namespace farrier::joint_node
