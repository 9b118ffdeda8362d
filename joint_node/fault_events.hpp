#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/fault.hpp"
#include "core/time.hpp"

namespace farrier::joint_node {

/// Turns a joint's faults, tick by tick, into the sentences of events: one for every change, with its cause. The safety
/// table has the text of each fault, and for how long a fault that comes and goes counts as present.
class FaultEvents {
 public:
  /// "sensors stale", "sensors stale, command stale" or "no fault"; empty while nothing changes.
  std::optional<std::string> update(Tick tick, FaultSet faults);

 private:
  static constexpr std::array<Tick, kFaults.size()> never() noexcept {
    std::array<Tick, kFaults.size()> ticks{};
    ticks.fill(kNoTick);
    return ticks;
  }

  FaultSet reported_;
  std::array<Tick, kFaults.size()> last_ = never();  ///< tick with the fault
};

}  // namespace farrier::joint_node
