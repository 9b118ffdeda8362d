#pragma once

#include <Eigen/Core>

#include "locomotion/attitude_filter.hpp"
#include "locomotion/base_estimator.hpp"
#include "locomotion/trunk_wrench.hpp"

namespace farrier::locomotion {

/// Estimation of the robot's state from IMU and joints.
struct StateEstimatorParams {
  AttitudeFilterParams attitude;
  BaseEstimatorParams base;
  double trusted_force_N = 30.0;               ///< a standing foot that carries less is trusted in proportion, > 0
  double foot_radius_m = 0.02175;              ///< of the foot's sphere, >= 0
  double still_rate_rad_s = 0.05;              ///< a robot that turns faster does not stand still, > 0
  double acceleration_time_constant_s = 0.25;  ///< of the derivative that corrects the attitude for acceleration, > 0
};

/// State of the whole robot, as far as IMU, joint angles, velocities and torques show it. World frame: z up, the origin on
/// the ground under the place where the estimator started, x along the heading at that time.
class StateEstimator {
 public:
  /// `model` must outlive the estimator.
  StateEstimator(const StateEstimatorParams& params, const BodyModel& model, double period_s) noexcept;

  /// Advances by one tick. `trust` is that of each foot (0 in the air .. 1 standing). `may_be_still` allows the bias of
  /// the gyroscope to be averaged. `acceleration_rad_s2` are the joint accelerations that were commanded last.
  void update(const Readings& readings, const PerLeg<double>& trust, bool may_be_still,
              const PerLeg<Eigen::Vector3d>& acceleration_rad_s2) noexcept;

  const BodyState& body() const noexcept { return body_; }
  const TrunkState& trunk() const noexcept { return trunk_; }

  /// Centre of the foot by the leg's kinematics, world frame.
  Eigen::Vector3d foot_m(int leg) const noexcept { return trunk_.position_m + feet_[leg].position_m; }
  Eigen::Vector3d foot_velocity_m_s(int leg) const noexcept { return trunk_.velocity_m_s + feet_[leg].velocity_m_s; }

  /// Force of the ground on the foot that explains the joint torques: f = J^-T (h + M q'' - tau), N, world frame
  /// (Focchi 2013; the leg's inertia acts with the commanded acceleration).
  const Eigen::Vector3d& ground_force_N(int leg) const noexcept { return forces_[leg]; }

  const AttitudeFilter& attitude() const noexcept { return attitude_; }
  const BaseEstimator& base() const noexcept { return base_; }

 private:
  void measure_feet(const PerLeg<double>& trust) noexcept;
  void measure_forces(const Readings& readings, const PerLeg<Eigen::Vector3d>& acceleration_rad_s2) noexcept;
  void correct_gyroscope(const PerLeg<FootMeasurement>& before, bool still) noexcept;

  StateEstimatorParams params_;
  const BodyModel& model_;
  double period_s_;
  AttitudeFilter attitude_;
  BaseEstimator base_;
  BodyState body_;
  TrunkState trunk_;
  PerLeg<FootMeasurement> feet_;
  PerLeg<Eigen::Vector3d> forces_;
  Eigen::Vector3d slow_velocity_ = Eigen::Vector3d::Zero();
  bool started_ = false;
};

}  // namespace farrier::locomotion
