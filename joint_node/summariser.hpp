#pragma once

#include <optional>

#include "signals/signals.hpp"

namespace farrier::joint_node {

/// Makes of one joint's measurements a summary every so many ticks. No allocation.
class Summariser {
 public:
  static constexpr double kRate_Hz = 50.0;

  /// `turn`: joints of one turn tell in the same tick, in one datagram, and those of different turns in different ticks, so
  /// that no tick has to carry the summaries of all.
  explicit Summariser(double period_s, Tick turn = 0) noexcept;

  /// The summary of the ticks before, once a measurement of the next ones comes, whichever is missing between. A joint
  /// that hears nothing tells its last measurement again and again: as many of them make a summary, too, of what it
  /// does meanwhile. Measurements before its first tick are left out; a tick that is earlier than the last begins anew.
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
