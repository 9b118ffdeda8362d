#pragma once

#include <string>

#include "gait/gait_params.hpp"

namespace farrier::gait {

/// Legs in the order in which they step, those that step together with a plus: "lf+rh, rf+lh". Empty if all stand.
std::string stepping_order(const RobotPlan& plan);

/// Share of the stride in which no leg is planned to stand, [0, 1).
double flight_share(const RobotPlan& plan);

}  // namespace farrier::gait
