#pragma once

#include <vector>

#include "core/time.hpp"
#include "tools/faults/fault_cell.hpp"

namespace farrier::faults {

/// When a process heard of the ticks of a run, by the computer's clock.
class TickTimes {
 public:
  /// In the order of both.
  void saw(Tick tick, SteadyTime at);

  /// All ticks that may have gone on between these times.
  TickSpan between(SteadyTime begin, SteadyTime end) const;

 private:
  struct Sighting {
    SteadyTime at;
    Tick tick;
  };

  std::vector<Sighting> sightings_;
};

}  // namespace farrier::faults
