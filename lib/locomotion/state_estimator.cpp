#include "locomotion/state_estimator.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "locomotion/rotation.hpp"

namespace farrier::locomotion {

StateEstimator::StateEstimator(const StateEstimatorParams& params, const BodyModel& model, double period_s) noexcept
    : params_(params),
      model_(model),
      period_s_(period_s),
      attitude_(params.attitude, period_s),
      base_(params.base, model.leg_count(), period_s) {
  forces_.fill(Eigen::Vector3d::Zero());
}

void StateEstimator::update(const Readings& readings, const PerLeg<double>& trust, bool may_be_still,
                            const PerLeg<Eigen::Vector3d>& acceleration_rad_s2) noexcept {
  const Eigen::Vector3d acceleration = (trunk_.velocity_m_s - slow_velocity_) / params_.acceleration_time_constant_s;
  const bool still = may_be_still && attitude_.angular_velocity_rad_s().norm() < params_.still_rate_rad_s && started_;
  if (started_) {
    attitude_.update(readings.imu, acceleration, still);
  } else {
    attitude_.reset(readings.imu.specific_force_m_s2);
  }
  trunk_.rotation = attitude_.rotation();
  trunk_.angular_velocity_rad_s = trunk_.rotation * attitude_.angular_velocity_rad_s();
  const Eigen::Vector3d gravity{0.0, 0.0, -kGravity_m_s2};
  model_.update({readings.legs.data(), static_cast<std::size_t>(model_.leg_count())},
                {trunk_.rotation.transpose() * gravity, attitude_.angular_velocity_rad_s()}, body_);
  measure_feet(trust);
  if (still) {
    attitude_.average_bias(readings.imu.angular_velocity_rad_s, angular_velocity_by_legs());
  }
  if (started_) {
    base_.update(trunk_.rotation * readings.imu.specific_force_m_s2 + gravity, feet_);
  } else {
    double height = 0.0;
    for (int leg = 0; leg < model_.leg_count(); ++leg) {
      height += (params_.foot_radius_m - feet_[leg].position_m.z()) / model_.leg_count();
    }
    base_.reset({0.0, 0.0, height}, feet_);
    started_ = true;
  }
  trunk_.position_m = base_.position_m();
  trunk_.velocity_m_s = base_.velocity_m_s();
  slow_velocity_ += period_s_ * acceleration;
  measure_forces(readings, acceleration_rad_s2);
}

void StateEstimator::measure_feet(const PerLeg<double>& trust) noexcept {
  const Eigen::Matrix3d& rotation = trunk_.rotation;
  const Eigen::Vector3d& rate = attitude_.angular_velocity_rad_s();
  for (int leg = 0; leg < model_.leg_count(); ++leg) {
    const LegState& state = body_.legs[leg];
    const Eigen::Vector3d shank_rate = rotation * (rate + state.shank_rate_rad_s);
    feet_[leg] = {.position_m = rotation * state.foot_m,
                  .velocity_m_s = rotation * (rate.cross(state.foot_m) + state.foot_velocity_m_s),
                  // a sphere on level ground: w x (radius z)
                  .rolling_m_s = params_.foot_radius_m * shank_rate.cross(Eigen::Vector3d::UnitZ()),
                  .trust = trust[leg]};
  }
}

// Rotation rate of the trunk against standing feet, by least squares: with d = s - mean(s) and u = s' - mean(s'),
//   u = -w x d   =>   sum (|d|^2 I - d d^T) w = -sum d x u.   Rolling of the feet is small while the robot stands.
Eigen::Vector3d StateEstimator::angular_velocity_by_legs() const noexcept {
  const int legs = model_.leg_count();
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::Vector3d speed = Eigen::Vector3d::Zero();
  for (int leg = 0; leg < legs; ++leg) {
    place += body_.legs[leg].foot_m / legs;
    speed += body_.legs[leg].foot_velocity_m_s / legs;
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Eigen::Vector3d turning = Eigen::Vector3d::Zero();
  for (int leg = 0; leg < legs; ++leg) {
    const Eigen::Vector3d d = body_.legs[leg].foot_m - place;
    spread += d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose();
    turning -= d.cross(body_.legs[leg].foot_velocity_m_s - speed);
  }
  Eigen::Matrix3d inverse;
  bool invertible = false;
  spread.computeInverseWithCheck(inverse, invertible);
  return invertible ? Eigen::Vector3d(inverse * turning) : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

void StateEstimator::measure_forces(const Readings& readings,
                                    const PerLeg<Eigen::Vector3d>& acceleration_rad_s2) noexcept {
  for (int leg = 0; leg < model_.leg_count(); ++leg) {
    const LegState& state = body_.legs[leg];
    Eigen::Matrix3d inverse;
    bool invertible = false;
    state.jacobian.computeInverseWithCheck(inverse, invertible, params_.least_determinant_m3);
    forces_[leg].setZero();
    if (invertible) {
      forces_[leg] = trunk_.rotation *
                     (inverse.transpose() * (state.bias_torque_Nm + state.inertia_kg_m2 * acceleration_rad_s2[leg] -
                                             readings.legs[leg].torque_Nm));
    }
  }
}

}  // namespace farrier::locomotion
