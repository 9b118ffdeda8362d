#include "thesis/rig/step_figures.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::thesis {

Signal step(double from_N, double to_N) {
  return [=](double t) { return t < kStep_s ? from_N : to_N; };
}

double overshoot(const RigTrace& run, double from_N, double to_N) {
  double furthest = 0.0;
  for (std::size_t i = 0; i < run.time_s.size(); ++i) {
    if (run.time_s[i] > kStep_s) {
      furthest = std::max(furthest, (run.force_N[i] - to_N) / (to_N - from_N));
    }
  }
  return furthest;
}

double rise_s(const RigTrace& run, double from_N, double to_N) {
  for (std::size_t i = 0; i < run.time_s.size(); ++i) {
    if (run.time_s[i] > kStep_s && (run.force_N[i] - from_N) / (to_N - from_N) >= 0.9) {
      return run.time_s[i] - kStep_s;
    }
  }
  return kStepRun_s;
}

double settled_s(const RigTrace& run, double from_N, double to_N) {
  double last = kStep_s;
  for (std::size_t i = 0; i < run.time_s.size(); ++i) {
    if (std::abs(run.force_N[i] - to_N) > 0.1 * std::abs(to_N - from_N)) {
      last = run.time_s[i];
    }
  }
  return last - kStep_s;
}

double steady_error(const RigTrace& run, double from_N, double to_N) {
  return std::abs(mean(run, run.force_N, kStepRun_s - 0.2, kStepRun_s) - to_N) / std::abs(to_N - from_N);
}

double largest(const RigTrace& run, const std::vector<double>& values, double from_s, double to_s) {
  double found = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (run.time_s[i] >= from_s && run.time_s[i] < to_s) {
      found = std::max(found, std::abs(values[i]));
    }
  }
  return found;
}

}  // namespace farrier::thesis
