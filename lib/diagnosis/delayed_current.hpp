#pragma once

#include <algorithm>

#include "diagnosis/constants.hpp"
#include "diagnosis/joint_data.hpp"
#include "plant/terms/terms.hpp"

namespace farrier::diagnosis {

/// The recorded current as it reaches the valve: late by the delay that the terms have.
template <class T>
class DelayedCurrent {
 public:
  /// Of a simulation that begins at sample `begin`; before it the current was what it is there. `data` outlives this.
  DelayedCurrent(const JointData& data, const plant::TermSet<T>& terms, std::size_t begin)
      : data_(&data), begin_(begin) {
    if (const auto* delay = terms.template find<plant::InputDelay>()) {
      delayed_ = true;
      delay_s_ = delay->delay_s();
    }
  }

  bool delayed() const noexcept { return delayed_; }

  /// Mean over substep `sub` of the recording, which lies in period `k`; A.
  T mean(std::size_t k, std::size_t sub) const {
    if (!delayed_) {
      return T(data_->current_A[k]);
    }
    const double h = data_->step_s();
    const T from = static_cast<double>(sub) * h - delay_s_;
    return (charge(from + h) - charge(from)) / h;
  }

 private:
  T charge(const T& at_s) const {
    const double place = value_of(at_s) / data_->period_s;
    const std::size_t i = place <= static_cast<double>(begin_)
                              ? begin_
                              : std::min(static_cast<std::size_t>(place), data_->size() - 1);
    return data_->current_integral[i] + (at_s - static_cast<double>(i) * data_->period_s) * data_->current_A[i];
  }

  const JointData* data_;
  std::size_t begin_;
  bool delayed_ = false;
  T delay_s_ = T(0.0);
};

}  // namespace farrier::diagnosis
