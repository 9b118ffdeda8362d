#pragma once

#include <optional>

#include "signals/signals.hpp"

namespace farrier::joint_node {

/// Makes of one joint's measurements a summary every so many ticks. No allocation.
class Summariser {
 public:
  static constexpr double kRate_Hz = 50.0;

  explicit Summariser(double period_s) noexcept;

  /// The summary of the ticks before, once a measurement of the next ones comes, whichever is missing between. A tick
  /// that is earlier than the last begins anew.
  std::optional<signals::JointSummary> take(const signals::JointMeasurement& measurement) noexcept;

 private:
  Tick ticks_;  ///< in one summary when none is missing
  Tick block_ = 0;
  signals::JointSummary summary_;  ///< so far; `ticks` 0: of none
  double squared_error_ = 0.0, squared_reference_ = 0.0;
};

}  // namespace farrier::joint_node
