#pragma once

#include <string>
#include <vector>

#include "core/noise.hpp"
#include "robot/robot.hpp"
#include "trials/truth/truth.hpp"

namespace farrier::truth {

/// Numbers of a seed, by name.
class Draws {
 public:
  Draws(const robot::Joint& joint, const Plan& plan, const char* channel) : stream_(plan.seed, joint.name, channel) {}
  double within(double low, double high) { return low + (high - low) * stream_.uniform(next_++); }
  double log_within(double low, double high);
  double sign() { return within(0.0, 1.0) < 0.5 ? -1.0 : 1.0; }

 private:
  NoiseStream stream_;
  Tick next_ = 0;
};

/// Levels of eight parts, shuffled within each half so that both hold calm and strong ones; ramps of 60 ms between.
std::vector<double> envelope(const robot::Joint& joint, const Plan& plan, double period_s, int ticks);

void add_sine(std::vector<double>& signal, double period_s, double omega, double amplitude, double phase);

}  // namespace farrier::truth
