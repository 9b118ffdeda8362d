#pragma once

#include <span>
#include <string>
#include <vector>

#include "diagnosis/wiring/wiring_hypotheses.hpp"

namespace farrier::diagnosis {

/// A fault of cables, signs, units or clocks that a recording has, or one of several that it may have.
struct WiringAnswer {
  WiringFault fault;
  std::string columns;      ///< as they stand in a file: "force_N", "pressure_a_Pa and pressure_b_Pa"
  double confidence = 0.0;  ///< in [0, 1]: weight exp(gain) of this fault among all faults and none
  double left = 0.0;  ///< share of the laws' deviation that undoing it leaves, geometric mean; 0 for a dead channel
};

/// The same moments of another joint of the robot.
struct OtherJoint {
  std::string name;
  Recording recording;
};

/// Bounds by which a fault is named: docs/decisions/0083-wiring-before-physics.md.
struct WiringRules {
  /// Sum over the laws of the logarithm of unexplained mean squares, without the fault over with it undone.
  double least_gain = 3.0;
  double most_unexplained = 0.35;         ///< of each law that undoing the fault changes, after it
  double most_unexplained_of_lag = 0.03;  ///< the same of a lag: an elastic gear looks like one that leaves 0.04
  double rival_weight = 0.05;             ///< of the best, above which another fault may be meant as well
  double dead_share = 0.02;               ///< of a channel's expected movement, below which it is dead
  double same_share = 0.02;               ///< of a channel's movement, within which it is another joint's
  /// The trials of `farrier diagnose --wiring` with a fault, hydraulic and electric, cannot show rarer errors.
  double most_confidence = 1.0 - 1.0 / 385.0;
};

/// Faults that a recording has: the likeliest first, then others that explain it about as well. Empty if no fault explains
/// far more than what effects can do. `others` are recordings of other joints at the same time, or none.
std::vector<WiringAnswer> find_wiring(const Recording& recording, const robot::Joint& joint,
                                      std::span<const OtherJoint> others = {}, const WiringRules& rules = {});

/// True if a law of some channel holds so badly that recordings of the other joints are worth reading.
bool may_be_of_another_joint(const Recording& recording, const robot::Joint& joint);

/// A stable snake_case word: "reversed", "mirrored", "dead", "scaled", "late", "early", "exchanged", "other_joint".
const char* to_string(WiringKind kind) noexcept;

/// Columns of the fault, as they stand in the recording's file: "force_N", "pressure_a_Pa and pressure_b_Pa".
std::string columns_of(const WiringFault& fault, const Recording& recording);

/// Findings of the file as a whole for people: the column, what is wrong, how sure that is and what to do. `joint` is the
/// recorded one.
std::vector<Finding> wiring_findings(const std::vector<WiringAnswer>& answers, const Recording& recording,
                                     const robot::Joint& joint);

}  // namespace farrier::diagnosis
