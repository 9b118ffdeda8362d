#include "locomotion/attitude_filter.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "locomotion/rotation.hpp"

namespace farrier::locomotion {

void AttitudeFilter::reset(const Eigen::Vector3d& specific_force_m_s2) noexcept {
  rotation_ = tilt_to(specific_force_m_s2.normalized()).transpose();
  bias_.setZero();
  angular_velocity_.setZero();
  still_s_ = 0.0;
}

void AttitudeFilter::update(const ImuReading& imu, const Eigen::Vector3d& acceleration_m_s2, bool still) noexcept {
  const Eigen::Vector3d up = rotation_.row(2).transpose();  // R^T z
  const Eigen::Vector3d gravity = imu.specific_force_m_s2 - rotation_.transpose() * acceleration_m_s2;
  // |f| is left in: impacts would shift the mean direction of normalised forces
  const Eigen::Vector3d error = gravity.cross(up) / kGravity_m_s2;
  angular_velocity_ = imu.angular_velocity_rad_s - bias_;
  const double gain = still ? params_.still_gravity_gain_1_s : params_.gravity_gain_1_s;
  correction_rad_s_ = gain * error;
  rotation_ = orthonormalised(rotation_ * rotation_by(period_s_ * (angular_velocity_ + correction_rad_s_)));
  if (!still) {
    bias_ -= period_s_ * params_.bias_gain_1_s2 * error;
  }
}

void AttitudeFilter::correct_bias(const Eigen::Vector3d& excess_rad_s, bool still) noexcept {
  const Eigen::Vector3d error = excess_rad_s - correction_rad_s_;
  if (still) {
    still_s_ = std::min(still_s_ + period_s_, params_.still_time_constant_s);
    bias_ += period_s_ / still_s_ * error;
  } else {
    const Eigen::Vector3d up = rotation_.row(2).transpose();
    bias_ += period_s_ / params_.moving_time_constant_s * up.dot(error) * up;
  }
}

}  // namespace farrier::locomotion
