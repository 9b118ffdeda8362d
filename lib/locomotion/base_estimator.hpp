#pragma once

#include <Eigen/Core>

#include "locomotion/body_model.hpp"

namespace farrier::locomotion {

/// Noise of the filter's inputs, as standard deviations. Densities are per square root of a hertz.
struct BaseEstimatorParams {
  double acceleration_noise_m_s2_rtHz = 0.03;  ///< accelerometer and attitude error, > 0
  double foot_slip_m_s_rtHz = 0.002;           ///< random walk of a foot that stands, > 0
  double foot_position_noise_m = 0.002;        ///< leg kinematics, > 0
  double foot_velocity_noise_m_s = 0.05;       ///< joint velocities and gyroscope, > 0
  double trust_ramp = 0.2;            ///< part of the stance at either end with less trust, 0..0.5 (Bledt 2018)
  double distrust = 100.0;            ///< factor on the deviations at no trust, >= 1 (MIT's estimator)
  double gate = 4.0;                  ///< innovations beyond this many deviations are not believed, > 0
  double initial_velocity_m_s = 0.1;  ///< standard deviation at reset, > 0
};

/// Measurement of one foot by the leg's kinematics and the gyroscope. World frame, relative to the trunk's origin.
struct FootMeasurement {
  Eigen::Vector3d position_m;    ///< R s
  Eigen::Vector3d velocity_m_s;  ///< R (w x s + s'), of the foot's centre relative to the trunk's
  Eigen::Vector3d rolling_m_s;   ///< velocity of the foot's centre over the ground while it rolls
  double trust;                  ///< 0 for a foot in the air, 1 for one that stands
};

/// Position and velocity of the trunk from accelerometer and legs. It is a linear Kalman filter in the spirit of Bloesch
/// et al. (2012). As in MIT's Cheetah 3 (Bledt et al. 2018), another filter gives the attitude.
///
/// The 6 + 3 n states are the trunk's position p and velocity v and the position p_i of each foot. They obey
///   p' = v,   v' = a = R f + g,   p_i' = rolling_i      with noise on a and on p_i'.
/// The legs measure every foot's place and, with feet that stand, the trunk's velocity:
///   p_i - p = R s_i,   v = rolling_i - R (w x s_i + s_i').
/// A foot whose position disagrees by more than the gate has slipped, and the filter places it again. It leaves out a
/// velocity that disagrees by more.
/// Every noise is equal in x, y and z, so the axes share one covariance of size 2 + n. The measurements are taken one at
/// a time, without an inverse. Absolute position and heading are not observable: they drift by slipping feet only.
class BaseEstimator {
 public:
  static constexpr int kMaxStates = 2 + kMaxLegs;

  BaseEstimator(const BaseEstimatorParams& params, int legs, double period_s) noexcept;

  /// Trust of a foot by its progress in stance: ramps from 0 to 1 and back. Negative progress is swing, without trust.
  double trust(double stance_progress) const noexcept;

  /// Starts at rest at `position_m`.
  void reset(const Eigen::Vector3d& position_m, const PerLeg<FootMeasurement>& feet) noexcept;

  /// Advances by one tick with the acceleration (m/s^2, world frame, gravity removed) and corrects with all feet.
  void update(const Eigen::Vector3d& acceleration_m_s2, const PerLeg<FootMeasurement>& feet) noexcept;

  Eigen::Vector3d position_m() const noexcept { return state_.row(kPosition).transpose(); }
  Eigen::Vector3d velocity_m_s() const noexcept { return state_.row(kVelocity).transpose(); }
  Eigen::Vector3d foot_m(int leg) const noexcept { return state_.row(kFeet + leg).transpose(); }
  /// Variance of the velocity, per axis, (m/s)^2.
  double velocity_variance() const noexcept { return covariance_(kVelocity, kVelocity); }

 private:
  static constexpr int kPosition = 0, kVelocity = 1, kFeet = 2;
  using State = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, kMaxStates, 3>;  // a row per state, a column per axis
  using Covariance = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxStates, kMaxStates>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxStates, 1>;

  void predict(const Eigen::Vector3d& acceleration_m_s2, const PerLeg<FootMeasurement>& feet) noexcept;
  void place_foot(int leg, const FootMeasurement& foot) noexcept;
  void correct(const Column& covariance_of_measured, double innovation_variance,
               const Eigen::RowVector3d& innovation) noexcept;
  double deviation_factor(double trust) const noexcept;

  BaseEstimatorParams params_;
  int legs_;
  double period_s_;
  State state_;
  Covariance covariance_;
};

}  // namespace farrier::locomotion
