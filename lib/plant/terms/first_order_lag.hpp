#pragma once

#include "plant/terms/portable.hpp"
#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Lag tau y' + y = x over one period, exact for an x that is a straight line between samples.
template <class T>
class FirstOrderLag {
 public:
  FirstOrderLag(const T& time_constant_s, double period_s) noexcept {
    using portable::exp;
    const T ratio = period_s / time_constant_s;
    const T decay = exp(-ratio);
    const T mean = (1.0 - decay) / ratio;
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

 private:
  T by_output_, by_last_, by_input_;
  T output_ = T(0.0);
  T last_ = T(0.0);
  bool started_ = false;
};

}  // namespace farrier::plant
