#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/units.hpp"
#include "diagnosis/wiring/wiring_relations.hpp"

namespace farrier::diagnosis {

/// Ways in which a channel is wrong.
enum class WiringKind { kReversed, kMirrored, kDead, kScaled, kLate, kEarly, kExchanged, kOtherJoint };

/// Factors that a wrong unit or range puts on a pressure in Pa.
inline constexpr std::array kPressureFactors{1e-6, 1e-5, 1e-3, 1e-2, 0.1, 10.0, 100.0, 1e3, 1.0 / kPascalPerPsi};

/// One way in which a recording may be wrong. `amount`: of kScaled the factor of the recorded numbers; of kLate and
/// kEarly samples, > 0; else 1.
struct WiringFault {
  WiringKind kind = WiringKind::kReversed;
  WiredChannel channel = WiredChannel::kForce;
  WiredChannel other = WiredChannel::kForce;  ///< of kExchanged: the channel with which it is exchanged
  double amount = 1.0;
  bool both_pressures = false;  ///< kPressureA stands for both
  std::string joint = {};       ///< of kOtherJoint: whose sensor it is
};

/// A fault with what undoing it leaves unexplained.
struct JudgedFault {
  WiringFault fault;
  Unexplained unexplained{};
  double gain = 0.0;  ///< sum over the laws of the logarithm of unexplained without the fault over with it undone
};

/// The changes that a fault is; none for one that only other columns than the recorded ones undo: a dead channel, one of
/// another joint, or two exchanged ones but for pressures.
std::optional<WiringHypothesis> wiring_hypothesis(const WiringFault& fault) noexcept;

/// Values of a channel; empty if it was not recorded.
std::vector<double>& column(Recording& recording, WiredChannel channel) noexcept;
const std::vector<double>& column(const Recording& recording, WiredChannel channel) noexcept;

/// Sum over the laws that both have of the logarithm of their ratios, floored at what no recording beats.
double log_gain(const Unexplained& before, const Unexplained& after) noexcept;

/// All faults of a recording with what undoing them brings, the largest gain first; of lags of one channel the best one.
/// `recording` is what `judge` was made of.
std::vector<JudgedFault> judge_faults(const WiringJudge& judge, const Recording& recording, const robot::Joint& joint);

}  // namespace farrier::diagnosis
