#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace farrier::plant {

/// A current some time ago: stretches of constant current, put in at one end and taken out at the other, so that a
/// delay need be no whole number of periods. Before the first one it was 0.
class DelayLine {
 public:
  struct Stretch {
    double current_A;
    double length_s;
  };
  /// Stretches shorter than this are none: what is left of a difference of lengths.
  static constexpr double kNoTime_s = 1e-12;

  DelayLine() = default;
  /// `delay_s` in [0, 1]; 0: none.
  explicit DelayLine(double delay_s) {
    if (delay_s > 0.0) {
      constexpr double kShortestPeriod_s = 1e-4;  // of a robot file; calls within one period bring the same current
      ring_.resize(static_cast<std::size_t>(std::ceil(delay_s / kShortestPeriod_s)) + 3);
      ring_[0] = {0.0, delay_s};
      count_ = 1;
    }
  }

  bool active() const noexcept { return !ring_.empty(); }

  /// `current_A` acts for the next `length_s` at this end. Where there are more stretches than a line holds the newest
  /// become one of their mean.
  void push(double current_A, double length_s) noexcept {
    Stretch& newest = ring_[(first_ + count_ + ring_.size() - 1) % ring_.size()];
    if (count_ > 0 && newest.current_A == current_A) {
      newest.length_s += length_s;
    } else if (count_ < ring_.size()) {
      ring_[(first_ + count_++) % ring_.size()] = {current_A, length_s};
    } else {
      const double sum_As = newest.current_A * newest.length_s + current_A * length_s;
      newest.length_s += length_s;
      newest.current_A = sum_As / newest.length_s;
    }
  }

  /// The oldest current and for how long it acts, `longest_s` at most. An empty line gives the last one.
  Stretch take(double longest_s) noexcept {
    Stretch& oldest = ring_[first_];
    if (count_ == 0 || oldest.length_s > longest_s + kNoTime_s) {
      oldest.length_s -= count_ == 0 ? 0.0 : longest_s;
      return {oldest.current_A, longest_s};
    }
    const Stretch whole{oldest.current_A, std::min(oldest.length_s, longest_s)};
    if (--count_ > 0) {
      first_ = (first_ + 1) % ring_.size();
    }
    return whole;
  }

 private:
  std::vector<Stretch> ring_;
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

}  // namespace farrier::plant
