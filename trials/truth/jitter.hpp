#pragma once

#include <cstdint>
#include <string>

#include "core/noise.hpp"

namespace farrier::truth {

/// Moves numbers of a robot file by 1 to 2 % either way, each call by a draw of its own.
class Jitter {
 public:
  Jitter(std::uint64_t seed, const std::string& joint) : stream_(seed, joint, "truth jitter") {}
  double operator()(double value) {
    const double sign = stream_.uniform(next_) < 0.5 ? -1.0 : 1.0;
    const double size = 0.01 + 0.01 * stream_.uniform(next_ + 1);
    next_ += 2;
    return value * (1.0 + sign * size);
  }

 private:
  NoiseStream stream_;
  Tick next_ = 0;
};

}  // namespace farrier::truth
