#pragma once

// Gains of the LQR over two parameters of a rig's load, and what can be said of them.

#include <array>
#include <vector>

#include "control/model/model_analysis.hpp"
#include "thesis/study/study.hpp"

namespace farrier::thesis {

using GainVector = std::array<double, 3>;  ///< K, normalised
enum Channel : std::size_t { kPosition, kVelocity, kForce };

/// Parameter that a map varies, over its set of 4.3.2.
struct Axis {
  const char* label;
  std::vector<double> values;
  control::LoadParameter parameter;
};

/// K of the LQR for the rig with another load, weights (7.9) to (7.11). Refuses where there is no design, naming the
/// load.
Result<GainVector> gains_for(const robot::Robot& rig, const plant::LoadParams& load);

/// K over two axes, [first][second].
struct Map {
  Axis first, second;
  std::vector<std::vector<GainVector>> k;
};

/// Over the rig's swing load. Refuses as gains_for.
Result<Map> make_map(const robot::Robot& rig, control::LoadParameter first, control::LoadParameter second);
Map transposed(const Map& map);

/// Share of the steps along the first axis over which |K| of the channel rises.
double rising(const Map& map, Channel channel);

/// Largest less smallest |K| of the channel along the first axis, over the largest of the whole map: at one value of the
/// second axis, or the largest of all.
double change(const Map& map, Channel channel, std::size_t j);
double change(const Map& map, Channel channel);

/// Panels of K over the first axis, a line per value of the second, black to yellow.
Picture picture_of(const Map& map);

}  // namespace farrier::thesis
