#pragma once

#include "core/result.hpp"
#include "report/figures/figures.hpp"
#include "robot/robot.hpp"

namespace farrier::cli {

/// False in a build without the robot as rigid bodies. Then measure_body() refuses.
bool has_body_part() noexcept;

/// A tick of the whole robot on a ground.
Result<Done> measure_body(const robot::Robot& robot, report::Figures& figures);

}  // namespace farrier::cli
