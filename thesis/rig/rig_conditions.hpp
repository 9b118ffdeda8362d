#pragma once

// A study on the rig, measured as the rig is and under the conditions of its claims.

#include <functional>
#include <span>

#include "thesis/study/study.hpp"

namespace farrier::thesis {

/// The rig under a condition; unchanged under one that is not about a rig.
robot::Robot under(Condition condition, robot::Robot rig);

using OnRig = std::function<Result<StudyResult>(const robot::Robot& rig)>;

/// Results of `measure` on the rig; each claim with a condition gets its value under that as well. Refuses what
/// `measure` refuses.
Result<StudyResult> measure_on(const robot::Robot& rig, std::span<const ClaimSpec> claims, const OnRig& measure);

}  // namespace farrier::thesis
