#pragma once

#include <cmath>

#include "core/noise.hpp"
#include "trials/truth/truth.hpp"

namespace farrier::truth {

/// A sensor's noise and digits.
class Channel {
 public:
  Channel(const Plan& plan, const robot::Joint& joint, const char* name, double noise, double step)
      : stream_(plan.seed, joint.name, name), noise_(noise), step_(step) {}
  double operator()(double truth, int tick) const {
    const double noisy = truth + noise_ * stream_.normal(tick);
    return step_ > 0.0 ? step_ * std::round(noisy / step_) : noisy;
  }

 private:
  NoiseStream stream_;
  double noise_, step_;
};

/// Root mean square about the mean of values, not empty.
double rms_about_mean(const std::vector<double>& values);

}  // namespace farrier::truth
