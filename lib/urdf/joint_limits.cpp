#include "urdf/joint_limits.hpp"

#include <algorithm>
#include <cmath>

#include "config/visitor.hpp"
#include "robot/checks/electric_check.hpp"

namespace farrier::urdf {
namespace {

/// Steps over the range of a joint; torque and speed of a triangle are smooth in its angle.
constexpr int kSteps = 200;

/// m/s or rad/s of the actuator.
double largest_speed(const robot::Joint& joint, const robot::RobotFile& file) {
  if (joint.electric) {
    const robot::Leg& leg = file.legs[static_cast<std::size_t>(joint.leg)].second;
    const std::string& section = leg.joints[static_cast<std::size_t>(joint.index_in_leg)].second;
    const robot::ElectricActuator* const drive = robot::electric_actuator_of(file, *config::find(file.joints, section));
    return drive->speed_limit_rad_s.value_or(plant::no_load_speed(*joint.electric));
  }
  const plant::ActuatorParams& a = joint.actuator;
  const double alpha = a.area_b / a.area_a;
  const double drop_Pa = (a.supply_pressure_Pa - alpha * a.return_pressure_Pa) / (1.0 + alpha * alpha * alpha);
  return a.valve_gain * a.valve_current_max_A * std::sqrt(drop_Pa) / a.area_a;
}

}  // namespace

JointLimits limits_of(const robot::Joint& joint, const robot::RobotFile& file) {
  double least_lever = std::abs(joint.linkage.lever(joint.angle_min_rad));
  double largest_lever = least_lever;
  for (int step = 1; step <= kSteps; ++step) {
    const double share = static_cast<double>(step) / kSteps;
    const double lever = std::abs(joint.linkage.lever(std::lerp(joint.angle_min_rad, joint.angle_max_rad, share)));
    least_lever = std::min(least_lever, lever);
    largest_lever = std::max(largest_lever, lever);
  }
  const double force = std::max(joint.push_limit, joint.pull_limit);
  return {.lower_rad = joint.angle_min_rad,
          .upper_rad = joint.angle_max_rad,
          .effort_Nm = largest_lever * force,
          .least_effort_Nm = least_lever * force,
          .velocity_rad_s = largest_speed(joint, file) / least_lever};
}

}  // namespace farrier::urdf
