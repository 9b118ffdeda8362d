#pragma once

#include <optional>

#include "signals/signals.hpp"

namespace farrier::joint_node {

/// Makes a summary of one joint's measurements every so many ticks. No allocation.
class Summariser {
 public:
  static constexpr double kRate_Hz = 50.0;

  /// Joints of the same `turn` send their summaries in the same tick, in one datagram. Those of different turns use
  /// different ticks, so that no tick carries all summaries.
  explicit Summariser(double period_s, Tick turn = 0) noexcept;

  /// Returns the summary of the previous ticks when a measurement of the next ones comes; ticks between may be missing.
  /// A joint without new inputs repeats its last measurement: an equal number of repetitions also makes a summary, so
  /// that its state stays visible. Measurements before its first tick are left out; a tick earlier than the last
  /// restarts the summary.
  std::optional<signals::JointSummary> take(const signals::JointMeasurement& measurement) noexcept;

 private:
  std::optional<signals::JointSummary> finish() noexcept;

  Tick ticks_;  ///< in one summary when none is missing
  Tick turn_;
  Tick block_ = 0;
  Tick last_tick_ = kNoTick;
  Tick again_ = 0;  ///< measurements of that tick after its first, since the last summary
  signals::JointSummary summary_;  ///< so far; tick kNoTick: of none
  double squared_error_ = 0.0, squared_reference_ = 0.0;
};

}  // namespace farrier::joint_node
