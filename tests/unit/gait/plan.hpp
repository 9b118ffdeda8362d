#pragma once

#include <cstdint>
#include <numbers>
#include <string>
#include <utility>

#include "gait/gait_params.hpp"

namespace farrier::gait {

inline constexpr double kStroke_m = 0.08;               // HyQ's cylinders
inline constexpr double kBodyWeight_N = 84.756 * 9.81;  // HyQ, with its legs

// Lengths, home pose and cylinder triangles of HyQ as iit-DLSLab publishes them (hyq-description, robotlib).
inline LegPlan hyq_leg(std::string name, bool left, bool front, double phase_offset, int first_joint) {
  // Loads are of the size such joints feel at their pistons; nothing here depends on their values.
  constexpr double kRightAngle = std::numbers::pi / 2;
  const double mirror = front ? -1.0 : 1.0;
  const auto hip = plant::Linkage::triangle({.side_a_m = 0.3219,
                                             .side_b_m = 0.045,
                                             .angle_at_zero_rad = kRightAngle + 0.1089,
                                             .angle_sign = 1.0,
                                             .mirror = mirror,
                                             .retracted_length_m = 0.281});
  const auto knee = plant::Linkage::triangle({.side_a_m = 0.3218,
                                              .side_b_m = 0.045,
                                              .angle_at_zero_rad = 2 * kRightAngle - 0.1403 - 0.1047,
                                              .angle_sign = -1.0,
                                              .mirror = mirror,
                                              .retracted_length_m = 0.281});
  const auto joint = [&](int index, plant::Linkage linkage, double swing, double stance, double home) {
    return JointPlan{.joint = static_cast<std::uint16_t>(first_joint + index),
                     .linkage = std::move(linkage),
                     .swing_load = {.mass = swing},
                     .stance_load = {.mass = stance},
                     .home_angle_rad = home,
                     .stiffness_Nm_rad = 50.0,
                     .damping_Nms_rad = 1.0};
  };
  return {.name = std::move(name),
          .geometry = {.left = left, .front = front},
          .joints = {joint(0, plant::Linkage::direct(1.0, -1.2), 0.5, 2.0, -0.2),
                     joint(1, hip.value(), 50.0, 300.0, -0.75 * mirror),
                     joint(2, knee.value(), 20.0, 200.0, 1.5 * mirror)},
          .phase_offset = phase_offset};
}

inline RobotPlan hyq_plan(double period_s = 0.001) {
  return {.period_s = period_s,
          .body_weight_N = kBodyWeight_N,
          .gait = {},
          .legs = {hyq_leg("lf", true, true, 0.0, 0), hyq_leg("rf", false, true, 0.5, 3),
                   hyq_leg("lh", true, false, 0.5, 6), hyq_leg("rh", false, false, 0.0, 9)}};
}

inline RobotPlan hyq_standing(double period_s = 0.001) {
  RobotPlan plan = hyq_plan(period_s);
  plan.gait.pattern = Pattern::kStand;
  return plan;
}

}  // namespace farrier::gait
