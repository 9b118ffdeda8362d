#pragma once

#include <Eigen/Core>

#include "locomotion/force_distribution.hpp"

namespace farrier::locomotion {

/// Gains of the trunk's control. Linear gains are per kilogram of the robot. Found by trotting a simulated HyQ.
struct TrunkWrenchParams {
  Eigen::Vector3d position_gain_1_s2{10.0, 10.0, 80.0};
  Eigen::Vector3d velocity_gain_1_s{6.0, 6.0, 14.0};
  Eigen::Vector3d attitude_gain_Nm_rad{1200.0, 1800.0, 600.0};  ///< about the trunk's axes: roll, pitch, yaw
  Eigen::Vector3d rate_gain_Nms_rad{150.0, 250.0, 120.0};
  double height_integral_1_s3 = 60.0;  ///< >= 0: removes the sag under an unknown mass
  double tilt_integral_1_s = 0.5;      ///< >= 0, relative to the attitude gain: removes the tilt under an unknown load
  double height_integral_limit_m_s2 = 5.0;  ///< of its acceleration: half the robot's weight
  double tilt_integral_limit_Nm = 150.0;
};

/// Motion of the trunk's origin and the attitude. World frame; the rotation is world from trunk.
struct TrunkState {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d angular_velocity_rad_s = Eigen::Vector3d::Zero();
};

/// Wrench on the trunk by MIT's balance controller (Focchi 2016; Bledt 2018), and integrals:
///   force  = m (g + K_p (x_d - x) + K_d (v_d - v) + k_i int(z_d - z)),
///   moment = K_R log(R_d R^T) + K_w (w_d - w) + tilt integral.
/// The attitude error is the sine vector of R_d R^T, which equals the logarithm for small errors. Gains and errors of
/// the moment are along the trunk's axes.
class TrunkWrench {
 public:
  TrunkWrench(const TrunkWrenchParams& params, double mass_kg, double period_s) noexcept
      : params_(params), mass_kg_(mass_kg), period_s_(period_s) {}

  /// Wrench of the ground on the robot, at its centre of mass, world frame. `share` (0..1) is the part of the weight
  /// that the legs carry by forces; below 1 the integrals rest.
  Wrench step(const TrunkState& wanted, const TrunkState& is, double share) noexcept;

  void reset_integrals() noexcept;

  /// Sets the mass of the robot, kg, > 0.
  void set_mass(double mass_kg) noexcept { mass_kg_ = mass_kg; }

 private:
  TrunkWrenchParams params_;
  double mass_kg_;
  double period_s_;
  double height_integral_m_s2_ = 0.0;
  Eigen::Vector3d tilt_integral_Nm_ = Eigen::Vector3d::Zero();
};

}  // namespace farrier::locomotion
