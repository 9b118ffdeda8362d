#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/time.hpp"
#include "gait/foot_path.hpp"
#include "gait/gait_params.hpp"
#include "gait/schedule.hpp"

namespace farrier::gait {

/// Reference of a joint at one tick.
struct JointReference {
  double position_rad = 0.0;
  double velocity_rad_s = 0.0;
  double acceleration_rad_s2 = 0.0;
  double torque_ff_Nm = 0.0;  ///< of the actuator on the joint, positive along +position
};

/// Share of the leg's load that is on at `stance_progress`: 0 at touchdown (0) and lift-off (1) and in swing (< 0),
/// 1 between the ramps that take `load_transfer_fraction` (0..0.5) of the stance each. C3 in the progress.
/// The reference uses it with the planned phase, the simulated load with the actual one.
double load_share(double stance_progress, double load_transfer_fraction) noexcept;

/// Joint references of the planned gait. The function at() is pure: it depends on leg, joint and tick only.
///
/// With kLegKinematics the foot moves by foot_motion() around its neutral place, fk(home angles) with the HAA axis at
/// hip_height_m above it. The hip reaches that height over the lead-in; the stride grows from nothing over the
/// stride_ticks() after it. Position, velocity and acceleration are each other's exact derivatives.
///
/// The feed-forward uses s = load_share(planned progress), J_z the vertical row of the leg's Jacobian, and r = dx/dq
/// the lever. The actuator's acceleration is x'' = r q'' + r' q'^2, its load m_w in swing and m_s in stance. The
/// feed-forward is
///   stance:  tau = -J_z^T s W / n + s r (m_w + s (m_s - m_w)) x'',
///   swing:   tau = w r m_w x'',   w ramps in and out over a tenth of the swing.
/// So it is continuous, and zero at lift-off and touchdown. W is the body's weight, which the stance legs carry
/// together. The divisor n is the sum of the shares of all legs, with 1 for a load that is still coming in, but at
/// least half the legs. Weight and inertia only: damping, springs and friction are left to the feedback.
///
/// With kMultisine the joints hold home; tau = r f(t), f = (amplitude / number) sum_i sin(2 pi f_i t), faded in over
/// the lead-in.
class Reference {
 public:
  /// `plan` must pass validate().
  explicit Reference(const RobotPlan& plan);

  JointReference at(int leg, int joint_in_leg, Tick tick) const noexcept;

  /// W / n: the vertical ground force on a leg whose whole share is on, N.
  double weight_per_share_N(Tick tick) const noexcept;

 private:
  JointReference multisine(const JointPlan& joint, Tick tick) const noexcept;
  JointReference leg_kinematics(int leg, int joint_in_leg, Tick tick) const noexcept;
  PointMotion foot(int leg, Tick tick) const noexcept;
  double share(int leg, Tick tick) const noexcept;
  double weight_on(int leg, Tick tick) const noexcept;
  double inertia_torque(int leg, const JointPlan& joint, const JointReference& motion, Tick tick) const noexcept;

  RobotPlan plan_;
  Schedule schedule_;
  FootPath path_;
  std::vector<Eigen::Vector3d> home_feet_;
};

}  // namespace farrier::gait
