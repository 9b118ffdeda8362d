#pragma once

#include <optional>

#include "diagnosis/judge/diagnosis.hpp"
#include "robot/robot.hpp"
#include "report/diagnosis/diagnosis_result.hpp"

namespace farrier::cli {

/// Returns the gain of force control from knowing the effects found, on the joint extended by them. Empty if a
/// controller can use none of them (control::is_compensated), or if the extended joint cannot be simulated or
/// controlled.
std::optional<report::ControlGain> control_gain(const robot::Robot& robot, const robot::Joint& joint,
                                                const diagnosis::Diagnosis& found);

}  // namespace farrier::cli
