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
  const PerLeg<FootMeasurement> before = feet_;
  measure_feet(trust);
  if (started_) {
    correct_gyroscope(before, still);
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

// Feet that stand keep their places in the world. If the gyroscope's bias is wrong by e, they seem to turn by e.
// With d = R s - mean(R s) and its change u per second,
//   u = e x d   =>   sum (|d|^2 I - d d^T) e = sum d x u.
// Changes of position are used, because their noise cancels from tick to tick. A robot that walks shows e about the
// vertical only.
void StateEstimator::correct_gyroscope(const PerLeg<FootMeasurement>& before, bool still) noexcept {
  PerLeg<int> standing{};
  int count = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::Vector3d change = Eigen::Vector3d::Zero();
  const auto moved = [&](int leg) -> Eigen::Vector3d {
    return feet_[leg].position_m - before[leg].position_m - period_s_ * feet_[leg].rolling_m_s;
  };
  for (int leg = 0; leg < model_.leg_count(); ++leg) {
    if (feet_[leg].trust >= 1.0 && before[leg].trust >= 1.0) {
      standing[count++] = leg;
      place += feet_[leg].position_m;
      change += moved(leg);
    }
  }
  if (count < 2) {
    return;
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Eigen::Vector3d turning = Eigen::Vector3d::Zero();
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d d = feet_[standing[i]].position_m - place / count;
    spread += d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose();
    turning += d.cross(moved(standing[i]) - change / count) / period_s_;
  }
  Eigen::Vector3d excess{0.0, 0.0, turning.z() / spread(2, 2)};
  if (still) {
    Eigen::Matrix3d inverse;
    bool invertible = false;
    spread.computeInverseWithCheck(inverse, invertible);
    if (invertible) {
      excess = inverse * turning;
    }
  }
  attitude_.correct_bias(trunk_.rotation.transpose() * excess, still);
}

void StateEstimator::measure_forces(const Readings& readings,
                                    const PerLeg<Eigen::Vector3d>& acceleration_rad_s2) noexcept {
  for (int leg = 0; leg < model_.leg_count(); ++leg) {
    const LegState& state = body_.legs[leg];
    Eigen::Matrix3d inverse;
    bool invertible = false;
    state.jacobian.computeInverseWithCheck(inverse, invertible, kSingularLeg_m3);
    forces_[leg].setZero();
    if (invertible) {
      forces_[leg] = trunk_.rotation *
                     (inverse.transpose() * (state.bias_torque_Nm + state.inertia_kg_m2 * acceleration_rad_s2[leg] -
                                             readings.legs[leg].torque_Nm));
    }
  }
}

}  // namespace farrier::locomotion
