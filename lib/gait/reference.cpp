#include "gait/reference.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/portable_math.hpp"
#include "gait/leg_kinematics.hpp"
#include "gait/smooth_step.hpp"

namespace farrier::gait {
namespace {

// Ramp of the swing's inertia torque at either end, as a part of the swing: the foot has hardly any acceleration there.
constexpr double kSwingRamp = 0.1;

Eigen::Vector3d home_angles(const LegPlan& leg) {
  return {leg.joints[0].home_angle_rad, leg.joints[1].home_angle_rad, leg.joints[2].home_angle_rad};
}

// Smooth step over the `length` ticks from `start` on, derivatives with respect to time.
Smooth fade_in(Tick tick, Tick start, Tick length, double period_s) noexcept {
  if (length == 0) {
    return {tick >= start ? 1.0 : 0.0, 0.0, 0.0};
  }
  const Smooth step = smooth_step(static_cast<double>(tick - start) / static_cast<double>(length));
  const double rate = 1.0 / (static_cast<double>(length) * period_s);
  return {step.value, step.slope * rate, step.curvature * rate * rate};
}

// a(t) p(t) by the product rule
PointMotion scaled(const PointMotion& p, const Smooth& a) noexcept {
  return {.position = a.value * p.position,
          .velocity = a.value * p.velocity + a.slope * p.position,
          .acceleration = a.value * p.acceleration + 2.0 * a.slope * p.velocity + a.curvature * p.position};
}

}  // namespace

double load_share(double stance_progress, double load_transfer_fraction) noexcept {
  const double to_the_nearer_end = std::min(stance_progress, 1.0 - stance_progress);
  if (to_the_nearer_end < 0.0) {
    return 0.0;
  }
  return load_transfer_fraction > 0.0 ? smooth_step(to_the_nearer_end / load_transfer_fraction).value : 1.0;
}

Reference::Reference(const RobotPlan& plan) : plan_(plan), schedule_(plan, 0) {  // the plan is the same for any seed
  const auto seconds = [&](Tick ticks) { return static_cast<double>(ticks) * plan.period_s; };
  const bool trot = plan.gait.pattern == Pattern::kTrot;
  path_ = {.step_length_m = trot ? plan.gait.step_length_m : 0.0,
           .step_height_m = trot ? plan.gait.step_height_m : 0.0,
           .stance_s = seconds(schedule_.stance_ticks()),
           .swing_s = seconds(schedule_.stride_ticks() - schedule_.stance_ticks())};
  if (plan.gait.reference == ReferenceKind::kLegKinematics) {
    for (const LegPlan& leg : plan_.legs) {
      home_feet_.push_back(fk(leg.geometry, home_angles(leg)));
    }
  }
}

JointReference Reference::at(int leg, int joint_in_leg, Tick tick) const noexcept {
  return plan_.gait.reference == ReferenceKind::kMultisine ? multisine(plan_.legs[leg].joints[joint_in_leg], tick)
                                                           : leg_kinematics(leg, joint_in_leg, tick);
}

JointReference Reference::multisine(const JointPlan& joint, Tick tick) const noexcept {
  const double time_s = static_cast<double>(std::max<Tick>(tick, 0)) * plan_.period_s;
  double sum = 0.0;
  for (const double frequency_Hz : plan_.gait.multisine_frequencies_Hz) {
    sum += portable::sin_of_turns(frequency_Hz * time_s);
  }
  const double amplitude_N =
      plan_.gait.multisine_amplitude_N / static_cast<double>(plan_.gait.multisine_frequencies_Hz.size());
  const double fade = fade_in(tick, 0, schedule_.lead_in_ticks(), plan_.period_s).value;
  return {.position_rad = joint.home_angle_rad,
          .torque_ff_Nm = joint.linkage.lever(joint.home_angle_rad) * fade * amplitude_N * sum};
}

PointMotion Reference::foot(int leg, Tick tick) const noexcept {
  const Eigen::Vector3d& home = home_feet_[leg];
  const Eigen::Vector3d neutral{home.x(), home.y(), -plan_.gait.hip_height_m};
  const double since_s = static_cast<double>(schedule_.ticks_since_touchdown(leg, tick)) * plan_.period_s;
  const Smooth rise = fade_in(tick, 0, schedule_.lead_in_ticks(), plan_.period_s);
  const Smooth grow = fade_in(tick, schedule_.lead_in_ticks(), schedule_.stride_ticks(), plan_.period_s);
  // p = p_home + rise (p_neutral - p_home) + grow p_stride
  const PointMotion lift = scaled({.position = neutral - home}, rise);
  const PointMotion stride = scaled(foot_motion(path_, since_s), grow);
  return {.position = home + lift.position + stride.position,
          .velocity = lift.velocity + stride.velocity,
          .acceleration = lift.acceleration + stride.acceleration};
}

double Reference::share(int leg, Tick tick) const noexcept {
  return load_share(schedule_.stance_progress(leg, tick), plan_.gait.load_transfer_fraction);
}

double Reference::weight_per_share_N(Tick tick) const noexcept {
  const int legs = static_cast<int>(plan_.legs.size());
  // In the first stance the load is on from the start as far as the other legs are concerned.
  const Tick loaded = std::max(tick, schedule_.lead_in_ticks());
  double carrying = 0.0;
  for (int other = 0; other < legs; ++other) {
    carrying += share(other, loaded);
  }
  const double at_least = std::max(1.0, 0.5 * legs);
  return plan_.body_weight_N / std::max(carrying, at_least);
}

double Reference::weight_on(int leg, Tick tick) const noexcept { return share(leg, tick) * weight_per_share_N(tick); }

double Reference::inertia_torque(int leg, const JointPlan& joint, const JointReference& motion,
                                 Tick tick) const noexcept {
  const bool swing = schedule_.phase(leg, tick) == Phase::kSwing;
  const double loaded = swing ? 0.0 : share(leg, tick);
  const double window = swing ? load_share(schedule_.swing_progress(leg, tick), kSwingRamp) : loaded;
  const double mass = joint.swing_load.mass + loaded * (joint.stance_load.mass - joint.swing_load.mass);
  // x'' = r q'' + r' q'^2
  const double lever = joint.linkage.lever(motion.position_rad);
  const double acceleration = lever * motion.acceleration_rad_s2 + joint.linkage.lever_slope(motion.position_rad) *
                                                                       motion.velocity_rad_s * motion.velocity_rad_s;
  return window * lever * mass * acceleration;
}

JointReference Reference::leg_kinematics(int leg, int joint_in_leg, Tick tick) const noexcept {
  const LegPlan& plan = plan_.legs[leg];
  const PointMotion point = foot(leg, tick);
  // validate() has seen the whole path in reach; were it not so, standing still is the safe answer
  const std::optional<Eigen::Vector3d> angles = ik(plan.geometry, point.position);
  if (!angles) {
    return {.position_rad = plan.joints[joint_in_leg].home_angle_rad};
  }
  // p' = J q',  p'' = J q'' + J' q'
  const Eigen::Matrix3d inverse = jacobian(plan.geometry, *angles).inverse();
  const Eigen::Vector3d rates = inverse * point.velocity;
  const Eigen::Vector3d accelerations =
      inverse * (point.acceleration - jacobian_rate(plan.geometry, *angles, rates) * rates);

  JointReference reference{.position_rad = (*angles)[joint_in_leg],
                           .velocity_rad_s = rates[joint_in_leg],
                           .acceleration_rad_s2 = accelerations[joint_in_leg]};
  reference.torque_ff_Nm = inertia_torque(leg, plan.joints[joint_in_leg], reference, tick) -
                           ground_torques(plan.geometry, *angles, weight_on(leg, tick))[joint_in_leg];
  return reference;
}

}  // namespace farrier::gait
