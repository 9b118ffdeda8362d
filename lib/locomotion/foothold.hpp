#pragma once

#include <Eigen/Core>

namespace farrier::locomotion {

/// Placement of the feet.
struct FootholdParams {
  double wider_m = 0.10;          ///< how far the neutral foot stands outside the hip, >= 0
  double velocity_gain_s = 0.18;  ///< k: shift per velocity error, >= 0; about sqrt(h / g) / sqrt(2) (Raibert 1986)
  double reach_m = 0.30;          ///< largest distance from the neutral place, per axis, > 0 (MIT: 0.3 m)
};

/// Motion of the trunk that a foothold depends on. World frame.
struct FootholdInput {
  Eigen::Vector3d hip_m;                ///< neutral place of the foot, under the hip and `wider_m` outside
  Eigen::Vector3d from_trunk_m;         ///< r, that place from the trunk's origin
  Eigen::Vector3d velocity_m_s;         ///< v
  Eigen::Vector3d wanted_velocity_m_s;  ///< v_d
  double wanted_yaw_rate_rad_s;         ///< omega_z
  double rest_s;                        ///< t_rest until touchdown
  double stance_s;                      ///< T_st
};

/// Foothold in the ground's plane, after Raibert (1986, ch. 2) with a step for turning.
///   hip + v t_rest + v_d T_st / 2 + k (v - v_d) + T_st / 2 w x r.
/// The sum after v t_rest is clamped to `reach_m`. The height is the hip's: the caller sets it.
Eigen::Vector3d foothold(const FootholdParams& params, const FootholdInput& input) noexcept;

}  // namespace farrier::locomotion
