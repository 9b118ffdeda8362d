#pragma once

#include <optional>

#include "gait/gait_params.hpp"
#include "locomotion/trot_controller.hpp"
#include "robot/robot_file.hpp"

namespace farrier::robot {

/// Parameters of the controller of the whole robot; none without the section locomotion. Hips, signs and the feet's
/// radius are those of body and legs. The file must have passed check_body and check_locomotion.
std::optional<locomotion::LocomotionParams> make_locomotion_params(const RobotFile& file);

/// The gait for feet that touch a ground. Their touchdowns come as they come: none is drawn.
gait::RobotPlan locomotion_plan(const gait::RobotPlan& plan);

}  // namespace farrier::robot
