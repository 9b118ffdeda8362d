#pragma once

// A study on the rig, measured as the rig is and under the conditions of its claims.

#include <functional>
#include <span>

#include "thesis/study/study.hpp"

namespace farrier::thesis {

// Conditions of the studies on the rig, as their pages print them.
#define FARRIER_RIG                                                                                               \
  "The rig of fc1d_real.yaml: spool, overlap and dry friction of the valve and the cart, mass of the oil in the " \
  "lines, "                                                                                                       \
  "noise of a potentiometer. Position and velocity pass 20 Hz, the force 100 Hz. "
inline constexpr const char* kOnTheRig = FARRIER_RIG "Nothing controls the valve.";
inline constexpr const char* kOnTheRigEstimated = FARRIER_RIG
    "The current is a chirp of 0 to 30 Hz in 8 s. The estimator is (6.21) with lambda 0.92, or with (9.1) to (9.3), "
    "c_1 = 4, M = 12.";
inline constexpr const char* kOnTheRigFullState = FARRIER_RIG
    "The LQR is for 2.5 kg, (7.9) to (7.11), xi = 6, with its whole feed-forward; nothing compensates the overlap.";
inline constexpr const char* kOnTheRigCompliant = FARRIER_RIG
    "The LQR is the compliant one for 2.5 kg, (7.9) to (7.11), xi = 6, with a tenth of the feed-forward of the design; "
    "nothing "
    "compensates the overlap.";
#undef FARRIER_RIG

/// The rig under a condition; unchanged under one that is not about a rig.
robot::Robot under(Condition condition, robot::Robot rig);

using OnRig = std::function<Result<StudyResult>(const robot::Robot& rig)>;

/// Results of `measure` on the rig; each claim with a condition gets its value under that as well. Pictures of a condition
/// that a claim needs stand behind those of the rig. Refuses what
/// `measure` refuses.
Result<StudyResult> measure_on(const robot::Robot& rig, std::span<const ClaimSpec> claims, const OnRig& measure);

}  // namespace farrier::thesis
