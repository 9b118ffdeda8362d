#pragma once

#include <algorithm>
#include <vector>

#include "diagnosis/model/constants.hpp"
#include "plant/terms/terms.hpp"

namespace farrier::diagnosis {

/// A command recorded by period: held over it, and its integral.
struct RecordedCommand {
  const std::vector<double>& values;
  const std::vector<double>& integral;  ///< values times seconds up to a sample; one more than samples
  double period_s;
};

/// A recorded command as it reaches the valve, late by the delay of the terms.
template <class T>
class DelayedCommand {
 public:
  /// Before the recording the command is constant at its first value. The vectors of `command` must outlive this.
  DelayedCommand(const RecordedCommand& command, const plant::TermSet<T>& terms) : command_(command) {
    if (const auto* delay = terms.template find<plant::InputDelay>()) {
      delayed_ = true;
      delay_s_ = delay->delay_s();
    }
  }

  bool delayed() const noexcept { return delayed_; }

  /// Mean over part `part` of period `k`, which has `parts`.
  T mean(std::size_t k, std::size_t part = 0, std::size_t parts = 1) const {
    if (!delayed_) {
      return T(command_.values[k]);
    }
    const double h = command_.period_s / static_cast<double>(parts);
    const T from = static_cast<double>(k * parts + part) * h - delay_s_;
    return (integral(from + h) - integral(from)) / h;
  }

 private:
  T integral(const T& at_s) const {
    const double place = value_of(at_s) / command_.period_s;
    const std::size_t i = place <= 0.0 ? 0 : std::min(static_cast<std::size_t>(place), command_.values.size() - 1);
    return command_.integral[i] + (at_s - static_cast<double>(i) * command_.period_s) * command_.values[i];
  }

  RecordedCommand command_;
  bool delayed_ = false;
  T delay_s_ = T(0.0);
};

}  // namespace farrier::diagnosis
