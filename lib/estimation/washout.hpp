#pragma once

#include <Eigen/Core>

#include <array>

namespace farrier::estimation {

/// Removes the slow means of position, velocity, force and current: a cascade of first-order high-pass filters. They
/// are the same for all four signals, so a linear model of the signals also holds for the output. A slowly changing
/// force (body weight) disappears (Astrom and Wittenmark 1994, 11.5, "data filters").
class Washout {
 public:
  static constexpr int kMaxOrder = 4;

  /// `smoothing` = period over time constant, (0, 1]; order 0..kMaxOrder, 0 lets everything through.
  Washout(double smoothing, int order) noexcept : smoothing_(smoothing), order_(order) {}

  /// The first sample is its own mean.
  Eigen::Vector4d pass(Eigen::Vector4d signal) noexcept {
    for (int stage = 0; stage < order_; ++stage) {
      Eigen::Vector4d& mean = means_[static_cast<std::size_t>(stage)];
      // m[k] = m[k-1] + (T / tau) (z[k] - m[k-1]),  out = z[k] - m[k]
      mean = started_ ? Eigen::Vector4d(mean + smoothing_ * (signal - mean)) : signal;
      signal -= mean;
    }
    started_ = true;
    return signal;
  }

  void reset() noexcept { started_ = false; }

 private:
  double smoothing_;
  int order_;
  bool started_ = false;
  std::array<Eigen::Vector4d, kMaxOrder> means_{};
};

}  // namespace farrier::estimation
