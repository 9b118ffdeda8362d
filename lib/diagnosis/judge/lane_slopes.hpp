#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "diagnosis/model/simulator.hpp"

namespace farrier::diagnosis {

/// Simulates a channel over a span, with derivatives by those of the free numbers that concern it, kLanes at a time. `put`
/// gets each derivative as put(sample of the span, place in `free`, slope). Returns the simulated values.
template <class Put>
std::vector<double> simulate_with_slopes(const Simulator& simulator, Span span, const Model& model, Channel channel,
                                         const Observer& observer, const std::vector<FreeNumber>& free, Put&& put) {
  std::vector<std::size_t> mine;
  for (std::size_t i = 0; i < free.size(); ++i) {
    if (free[i].channels[static_cast<std::size_t>(channel)]) {
      mine.push_back(i);
    }
  }
  std::vector<double> values;
  bool first = true;
  for (std::size_t from = 0; from < mine.size() || first; from += Simulator::kLanes) {
    std::vector<std::size_t> lanes;
    for (std::size_t i = from; i < std::min(from + Simulator::kLanes, mine.size()); ++i) {
      lanes.push_back(free[mine[i]].place);
    }
    std::vector<double> jacobian;
    std::vector<double> simulated = simulator.simulate_lanes(span, model, channel, observer, lanes, jacobian);
    for (std::size_t sample = 0; sample < span.size(); ++sample) {
      for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
        put(sample, mine[from + lane], jacobian[sample * lanes.size() + lane]);
      }
    }
    if (first) {
      values = std::move(simulated);
    }
    first = false;
  }
  return values;
}

}  // namespace farrier::diagnosis
