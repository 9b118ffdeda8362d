#include "tools/faults/tick_times.hpp"

#include <algorithm>
#include <limits>

namespace farrier::faults {

void TickTimes::saw(Tick tick, SteadyTime at) {
  if (sightings_.empty() || sightings_.back().tick != tick) {
    sightings_.push_back({at, tick});
  }
}

TickSpan TickTimes::between(SteadyTime begin, SteadyTime end) const {
  const auto after_begin = std::ranges::upper_bound(sightings_, begin, {}, &Sighting::at);
  const auto after_end = std::ranges::lower_bound(sightings_, end, {}, &Sighting::at);
  return {after_begin == sightings_.begin() ? 0 : std::prev(after_begin)->tick,
          after_end == sightings_.end() ? std::numeric_limits<Tick>::max() : after_end->tick + 1};
}

}  // namespace farrier::faults
