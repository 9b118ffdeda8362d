#pragma once

// Result of `farrier compare noise`.

#include <array>
#include <span>
#include <string>
#include <vector>

#include "report/figures/figures.hpp"

namespace farrier::report {

/// Noise of the sensors over that of the robot file.
struct NoiseFactor {
  const char* name;  ///< in figures
  double value;
};

/// From good sensors to bad ones.
inline constexpr std::array kNoiseFactors{NoiseFactor{"none", 0.0}, NoiseFactor{"hundredth", 0.01},
                                          NoiseFactor{"tenth", 0.1}, NoiseFactor{"nominal", 1.0},
                                          NoiseFactor{"triple", 3.0}};

/// Larger NRMSE of the force in the two heavy and in the two light quarters of the load cycle.
struct RigNoise {
  double heavy = 0.0, light = 0.0;
};

/// The load cycle under one seed.
struct RigSeed {
  RigNoise linear, true_gains, grey_box;
};

/// Median NRMSE in stance over the joints and seeds of `farrier compare varied`.
struct TrotNoise {
  double linear = 0.0, perfect = 0.0, grey_box = 0.0;
};

struct NoiseLevel {
  NoiseFactor factor = kNoiseFactors[0];
  std::vector<RigSeed> rig;  ///< by seed
  TrotNoise trot;
};

inline constexpr double kHeavyAtMost = 0.08;
inline constexpr double kLightRatioAtMost = 1.05;
inline constexpr double kTrotRatioAtMost = 1.3;
inline constexpr double kRiseAtMost = 1.1;  ///< of an error as the noise falls

/// Adds compare.noise.*. Bounds are on levels up to that of the robot file. Levels stand in the order of kNoiseFactors.
void add_noise(Figures& figures, std::span<const NoiseLevel> levels);

/// Table for people: a line for each level.
std::string noise_text(std::span<const NoiseLevel> levels);

}  // namespace farrier::report
