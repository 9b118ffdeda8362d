#pragma once

#include "core/portable_math.hpp"
#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Lag tau y' + y = x over one period, exact for an x that is a straight line between samples.
template <class T>
class FirstOrderLag {
 public:
  FirstOrderLag(const T& time_constant_s, double period_s) noexcept {
    using portable::exp;
    ratio_ = period_s / time_constant_s;
    const T decay = exp(-ratio_);
    const T mean = (1.0 - decay) / ratio_;
    by_output_ = decay;
    by_last_ = mean - decay;
    by_input_ = 1.0 - mean;
  }

  T take(const T& input) noexcept {
    output_ = started_ ? T(by_output_ * output_ + by_last_ * last_ + by_input_ * input) : input;
    started_ = true;
    last_ = input;
    return output_;
  }

  /// Input at the end of a period over which the output went from `from` to `to`. The input went from `last` along a
  /// straight line, plus `bend`, given as means over equal parts of the period.
  template <std::size_t kParts>
  T input_for(const T& from, const T& to, const T& last, const std::array<T, kParts>& bend) const noexcept {
    using portable::exp;
    const T part = exp(-ratio_ / static_cast<double>(kParts));
    T beyond(0.0);
    for (const T& mean : bend) {
      beyond = part * beyond + (1.0 - part) * mean;
    }
    return (to - by_output_ * from - by_last_ * last - beyond) / by_input_;
  }

 private:
  T ratio_;  ///< period over time constant
  T by_output_, by_last_, by_input_;
  T output_ = T(0.0);
  T last_ = T(0.0);
  bool started_ = false;
};

}  // namespace farrier::plant
