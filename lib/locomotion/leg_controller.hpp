#pragma once

#include <Eigen/Core>

#include "gait/foot_path.hpp"
#include "locomotion/body_model.hpp"

namespace farrier::locomotion {

/// Control of one leg.
struct LegControllerParams {
  Eigen::Vector3d swing_stiffness_N_m{1000.0, 1000.0, 1000.0};  ///< of the foot, trunk frame
  Eigen::Vector3d swing_damping_Ns_m{35.0, 35.0, 35.0};
  Eigen::Vector3d pose_stiffness_Nm_rad{300.0, 300.0, 300.0};  ///< of the joints: HAA, HFE, KFE
  Eigen::Vector3d pose_damping_Nms_rad{12.0, 12.0, 12.0};
  Eigen::Vector3d stop_damping_Nms_rad{20.0, 20.0, 20.0};  ///< of a robot that has fallen
  Eigen::Vector3d torque_limit_Nm{110.0, 140.0, 140.0};    ///< below what the joints can give
  double longest_leg_m = 0.73;                             ///< hip to foot: references further away are shortened, > 0
  double load_in_s = 0.03;   ///< in which the limit of a foot's normal force grows after touchdown, >= 0
  double load_out_s = 0.04;  ///< in which it falls before lift-off, >= 0
};

/// A foot's reference in the trunk frame, and what the trunk does meanwhile.
struct FootReference {
  Eigen::Vector3d position_m;
  Eigen::Vector3d velocity_m_s;  ///< relative to the trunk
  Eigen::Vector3d acceleration_m_s2;
};

/// Torques of the three joints of one leg. Stateless.
class LegController {
 public:
  explicit LegController(const LegControllerParams& params) noexcept : params_(params) {}

  /// Stance: tau = h - J^T f, for the force f of the ground on the foot (N, trunk frame).
  Eigen::Vector3d stance(const LegState& leg, const Eigen::Vector3d& force_N) const noexcept;

  /// Swing: tau = h + M q'' + J^T (K (s_d - s) + D (s_d' - s')), q'' = J^-1 (s_d'' - J' q'). A leg that is singular gets
  /// no q''. `acceleration_rad_s2` returns q''.
  Eigen::Vector3d swing(const LegState& leg, const FootReference& foot,
                        Eigen::Vector3d& acceleration_rad_s2) const noexcept;

  /// Joint stiffness and damping towards a pose, both scaled by `gain` (0..1).
  Eigen::Vector3d pose(const LegReadings& leg, const Eigen::Vector3d& wanted_rad, double gain) const noexcept;

  /// Damping only.
  Eigen::Vector3d damp(const LegReadings& leg) const noexcept;

  /// Torques within the limits; not a number becomes zero.
  Eigen::Vector3d limited(const Eigen::Vector3d& torque_Nm) const noexcept;

  /// Foot (trunk frame) no further from the hip than the leg reaches.
  Eigen::Vector3d within_reach(const Eigen::Vector3d& hip_m, const Eigen::Vector3d& foot_m) const noexcept;

  /// Largest force along `normal` (trunk frame) that the torque limits allow: |tau_j| = |J_n,j| f.
  double largest_force_N(const LegState& leg, const Eigen::Vector3d& normal) const noexcept;

 private:
  LegControllerParams params_;
};

}  // namespace farrier::locomotion
