#pragma once

#include <Eigen/Core>

#include "locomotion/controller.hpp"

namespace farrier::locomotion {

/// Gains of the attitude filter. Slow gains act while the robot moves, fast ones while it is at rest.
struct AttitudeFilterParams {
  double gravity_gain_1_s = 0.1;         ///< k_P, >= 0: 1/k_P is the time constant of roll and pitch corrections
  double bias_gain_1_s2 = 0.002;         ///< k_I, >= 0: k_P^2 / 4 and less is free of overshoot
  double still_gravity_gain_1_s = 1.0;   ///< k_P of a robot at rest
  double moving_time_constant_s = 30.0;  ///< of the yaw bias that standing feet show while the robot walks, > 0
  double still_time_constant_s = 30.0;   ///< memory of the bias that a robot at rest averages, > 0
};

/// Attitude of the trunk from gyroscope and accelerometer: the explicit complementary filter with bias correction
/// (Mahony, Hamel and Pflimlin 2008, eqs. (32)). With e = f x R^T z / g for the specific force f,
///   R' = R skew(w - b + k_P e),   b' = -k_I e.
/// The acceleration of the trunk is subtracted from the specific force where the caller knows it.
/// The error is linear in f: impacts would shift the mean of normalised or gated forces, by 1.5 degrees in a trot.
/// Gravity shows no yaw, so the heading starts at zero and drifts. Standing feet show that drift: correct_bias() takes it.
class AttitudeFilter {
 public:
  AttitudeFilter(const AttitudeFilterParams& params, double period_s) noexcept : params_(params), period_s_(period_s) {}

  /// Takes roll and pitch from one specific force (m/s^2, trunk frame, not zero), the heading zero, the bias zero.
  void reset(const Eigen::Vector3d& specific_force_m_s2) noexcept;

  /// Advances by one tick. `acceleration_m_s2` is the trunk's acceleration in the world frame, zero if unknown.
  void update(const ImuReading& imu, const Eigen::Vector3d& acceleration_m_s2, bool still) noexcept;

  /// Takes the angular velocity (rad/s, trunk frame) with which feet that stand turned in the world during the last
  /// update(), because rotation() turned by too much. The part that the gravity correction caused is not the bias's.
  /// If the robot is at rest, the bias becomes the mean of all such ticks. Else only its vertical part is
  /// corrected: two feet leave the axis between them open.
  void correct_bias(const Eigen::Vector3d& excess_rad_s, bool still) noexcept;

  /// World from trunk, z up.
  const Eigen::Matrix3d& rotation() const noexcept { return rotation_; }
  /// Angular velocity without bias, trunk frame, rad/s.
  const Eigen::Vector3d& angular_velocity_rad_s() const noexcept { return angular_velocity_; }
  const Eigen::Vector3d& bias_rad_s() const noexcept { return bias_; }

 private:
  AttitudeFilterParams params_;
  double period_s_;
  double still_s_ = 0.0;
  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d angular_velocity_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d correction_rad_s_ = Eigen::Vector3d::Zero();  // k_P e of the last update
  Eigen::Vector3d bias_ = Eigen::Vector3d::Zero();
};

}  // namespace farrier::locomotion
