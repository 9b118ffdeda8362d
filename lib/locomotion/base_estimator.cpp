#include "locomotion/base_estimator.hpp"

#include <algorithm>

namespace farrier::locomotion {
namespace {

double squared(double x) noexcept { return x * x; }

}  // namespace

BaseEstimator::BaseEstimator(const BaseEstimatorParams& params, int legs, double period_s) noexcept
    : params_(params),
      legs_(legs),
      period_s_(period_s),
      state_(State::Zero(kFeet + legs, 3)),
      covariance_(Covariance::Zero(kFeet + legs, kFeet + legs)) {}

double BaseEstimator::trust(double stance_progress) const noexcept {
  const double to_the_nearer_end = std::min(stance_progress, 1.0 - stance_progress);
  return params_.trust_ramp > 0.0 ? std::clamp(to_the_nearer_end / params_.trust_ramp, 0.0, 1.0)
                                  : (to_the_nearer_end >= 0.0 ? 1.0 : 0.0);
}

double BaseEstimator::deviation_factor(double trust) const noexcept { return 1.0 + (1.0 - trust) * params_.distrust; }

void BaseEstimator::reset(const Eigen::Vector3d& position_m, const PerLeg<FootMeasurement>& feet) noexcept {
  state_.setZero();
  covariance_.setZero();
  state_.row(kPosition) = position_m.transpose();
  covariance_(kVelocity, kVelocity) = squared(params_.initial_velocity_m_s);
  for (int leg = 0; leg < legs_; ++leg) {
    place_foot(leg, feet[leg]);
  }
}

// Sets a foot to where the kinematics see it: p_i = p + R s_i, with the covariance that follows.
void BaseEstimator::place_foot(int leg, const FootMeasurement& foot) noexcept {
  const int row = kFeet + leg;
  state_.row(row) = state_.row(kPosition) + foot.position_m.transpose();
  covariance_.row(row) = covariance_.row(kPosition);
  covariance_.col(row) = covariance_.row(row).transpose();
  covariance_(row, row) = covariance_(kPosition, kPosition) + squared(params_.foot_position_noise_m);
}

void BaseEstimator::predict(const Eigen::Vector3d& acceleration_m_s2, const PerLeg<FootMeasurement>& feet) noexcept {
  const double h = period_s_;
  const Eigen::RowVector3d a = acceleration_m_s2.transpose();
  state_.row(kPosition) += h * state_.row(kVelocity) + 0.5 * h * h * a;
  state_.row(kVelocity) += h * a;
  // P <- F P F^T + Q, F = I but for dp/dv = h
  covariance_.row(kPosition) += h * covariance_.row(kVelocity);
  covariance_.col(kPosition) += h * covariance_.col(kVelocity);
  const double q = squared(params_.acceleration_noise_m_s2_rtHz) * h;  // of the velocity, (m/s)^2
  covariance_(kVelocity, kVelocity) += q;
  covariance_(kPosition, kVelocity) += 0.5 * h * q;
  covariance_(kVelocity, kPosition) += 0.5 * h * q;
  covariance_(kPosition, kPosition) += h * h * q / 3.0;
  for (int leg = 0; leg < legs_; ++leg) {
    const int row = kFeet + leg;
    state_.row(row) += h * feet[leg].rolling_m_s.transpose();
    covariance_(row, row) += squared(params_.foot_slip_m_s_rtHz * deviation_factor(feet[leg].trust)) * h;
  }
}

// Kalman's correction by one measurement per axis: K = c / s, x <- x + K y, P <- P - K c^T.
void BaseEstimator::correct(const Column& c, double s, const Eigen::RowVector3d& innovation) noexcept {
  const Column gain = c / s;
  state_.noalias() += gain * innovation;
  covariance_.noalias() -= gain * c.transpose();
}

void BaseEstimator::update(const Eigen::Vector3d& acceleration_m_s2, const PerLeg<FootMeasurement>& feet) noexcept {
  predict(acceleration_m_s2, feet);
  for (int leg = 0; leg < legs_; ++leg) {
    const FootMeasurement& foot = feet[leg];
    if (!(foot.trust > 0.0)) {
      place_foot(leg, foot);
      continue;
    }
    const int row = kFeet + leg;
    const double factor = deviation_factor(foot.trust);
    // p_i - p = R s_i
    const Column apart = covariance_.col(row) - covariance_.col(kPosition);
    const double apart_variance = apart[row] - apart[kPosition] + squared(params_.foot_position_noise_m);
    const Eigen::RowVector3d way = foot.position_m.transpose() - (state_.row(row) - state_.row(kPosition));
    if (way.squaredNorm() > squared(params_.gate) * apart_variance) {
      place_foot(leg, foot);
      continue;
    }
    correct(apart, apart_variance, way);
    // v = rolling - R (w x s + s')
    const Column speed = covariance_.col(kVelocity);
    const double speed_variance = speed[kVelocity] + squared(params_.foot_velocity_noise_m_s * factor);
    const Eigen::RowVector3d slower = (foot.rolling_m_s - foot.velocity_m_s).transpose() - state_.row(kVelocity);
    if (slower.squaredNorm() <= squared(params_.gate) * speed_variance) {
      correct(speed, speed_variance, slower);
    }
  }
  covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();
}

}  // namespace farrier::locomotion
