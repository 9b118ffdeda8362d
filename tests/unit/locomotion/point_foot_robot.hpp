#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "gait/leg_kinematics.hpp"
#include "locomotion/controller.hpp"
#include "locomotion/rotation.hpp"
#include "locomotion/trot_controller.hpp"
#include "tests/unit/gait/plan.hpp"
#include "tests/unit/locomotion/hyq.hpp"

namespace farrier::locomotion {

/// A quadruped of HyQ's size for tests without a physics engine: a rigid trunk and four feet that are points with mass.
/// The legs between them have no mass. The ground is a spring with damping and Coulomb friction.
class PointFootRobot final : public BodyModel {
 public:
  static constexpr int kLegs = 4;
  static constexpr double kTrunk_kg = 78.0, kFoot_kg = 1.5;
  static constexpr double kPeriod_s = 0.001;

  /// Stands on folded legs.
  explicit PointFootRobot(const LocomotionParams& params) : params_(params), plan_(gait::hyq_plan(kPeriod_s)) {
    plan_.gait.touchdown_jitter_s = 0.0;
    for (int leg = 0; leg < kLegs; ++leg) {
      feet_[leg] = params_.mounts[leg].hip_m + gait::fk(plan_.legs[leg].geometry, params_.mounts[leg].folded_rad);
      place_.z() = params_.estimator.foot_radius_m - feet_[leg].z();
    }
    for (auto& foot : feet_) {
      foot += place_;
    }
    speeds_.fill(Eigen::Vector3d::Zero());
  }

  int leg_count() const noexcept override { return kLegs; }
  double mass_kg() const noexcept override { return kTrunk_kg + kLegs * kFoot_kg; }

  void update(std::span<const LegReadings> legs, const TrunkMotion& trunk, BodyState& state) const noexcept override {
    state.com_m.setZero();
    for (int i = 0; i < kLegs; ++i) {
      const gait::LegGeometry& geometry = plan_.legs[i].geometry;
      LegState& leg = state.legs[i];
      leg.foot_m = params_.mounts[i].hip_m + gait::fk(geometry, legs[i].position_rad);
      leg.jacobian = gait::jacobian(geometry, legs[i].position_rad);
      leg.foot_velocity_m_s = leg.jacobian * legs[i].velocity_rad_s;
      leg.foot_bias_m_s2 =
          gait::jacobian_rate(geometry, legs[i].position_rad, legs[i].velocity_rad_s) * legs[i].velocity_rad_s;
      leg.shank_rate_rad_s.setZero();  // a point does not roll
      leg.inertia_kg_m2 = kFoot_kg * leg.jacobian.transpose() * leg.jacobian;
      leg.bias_torque_Nm = leg.jacobian.transpose() * (kFoot_kg * (leg.foot_bias_m_s2 - trunk.gravity_m_s2));
      state.com_m += kFoot_kg / mass_kg() * leg.foot_m;
    }
  }

  /// Readings without noise. The torques are those that act.
  Readings readings() const {
    Readings readings;
    for (int i = 0; i < kLegs; ++i) {
      const Eigen::Vector3d foot = rotation_.transpose() * (feet_[i] - place_);
      const gait::LegGeometry& geometry = plan_.legs[i].geometry;
      LegReadings& leg = readings.legs[i];
      leg.position_rad = gait::ik(geometry, foot - params_.mounts[i].hip_m).value_or(leg.position_rad);
      leg.velocity_rad_s = gait::jacobian(geometry, leg.position_rad).inverse() *
                           (rotation_.transpose() * (speeds_[i] - velocity_ - rate_.cross(feet_[i] - place_)));
      leg.torque_Nm = torques_[i];
    }
    readings.imu = {rotation_.transpose() * rate_,
                    rotation_.transpose() * (acceleration_ + Eigen::Vector3d{0.0, 0.0, kGravity_m_s2})};
    return readings;
  }

  /// Applies the torques for one tick. `push_N` acts at the trunk's centre.
  void step(const LegTorques& torques, const Eigen::Vector3d& push_N = Eigen::Vector3d::Zero()) {
    constexpr int kSubsteps = 4;
    torques_ = torques;
    const Eigen::Vector3d before = velocity_;
    for (int k = 0; k < kSubsteps; ++k) {
      substep(kPeriod_s / kSubsteps, push_N);
    }
    acceleration_ = (velocity_ - before) / kPeriod_s;
  }

  const gait::RobotPlan& plan() const { return plan_; }
  const Eigen::Vector3d& place_m() const { return place_; }
  const Eigen::Vector3d& velocity_m_s() const { return velocity_; }
  const Eigen::Matrix3d& rotation() const { return rotation_; }

 private:
  Eigen::Vector3d ground_force_N(int leg) const {
    constexpr double kStiffness_N_m = 5e4, kDamping_Ns_m = 500.0, kFriction = 0.8, kCreep_Ns_m = 2000.0;
    const double depth = params_.estimator.foot_radius_m - feet_[leg].z();
    if (depth <= 0.0) {
      return Eigen::Vector3d::Zero();
    }
    const double normal = std::max(0.0, kStiffness_N_m * depth - kDamping_Ns_m * speeds_[leg].z());
    Eigen::Vector3d force = -kCreep_Ns_m * speeds_[leg];
    force.z() = 0.0;
    const double most = kFriction * normal;
    force *= force.norm() > most ? most / force.norm() : 1.0;
    force.z() = normal;
    return force;
  }

  // Stops of HFE and KFE, which carry a robot that lies.
  static Eigen::Vector3d stop_torque_Nm(const LegReadings& leg) {
    constexpr double kStop_rad[kJointsPerLeg] = {10.0, 1.22, 2.44};
    constexpr double kStiffness_Nm_rad = 3000.0, kDamping_Nms_rad = 10.0;
    Eigen::Vector3d torque = Eigen::Vector3d::Zero();
    for (int j = 0; j < kJointsPerLeg; ++j) {
      const double beyond = std::abs(leg.position_rad[j]) - kStop_rad[j];
      if (beyond > 0.0) {
        torque[j] =
            -std::copysign(kStiffness_Nm_rad * beyond, leg.position_rad[j]) - kDamping_Nms_rad * leg.velocity_rad_s[j];
      }
    }
    return torque;
  }

  void substep(double h, const Eigen::Vector3d& push_N) {
    const Eigen::Vector3d gravity{0.0, 0.0, -kGravity_m_s2};
    const Readings now = readings();
    Eigen::Vector3d force = push_N + kTrunk_kg * gravity;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (int i = 0; i < kLegs; ++i) {
      const Eigen::Matrix3d jacobian = gait::jacobian(plan_.legs[i].geometry, now.legs[i].position_rad);
      const Eigen::Vector3d torque = torques_[i] + stop_torque_Nm(now.legs[i]);
      const Eigen::Vector3d leg = rotation_ * (jacobian.transpose().inverse() * torque);  // on the foot
      force -= leg;
      moment -= (feet_[i] - place_).cross(leg);
      speeds_[i] += h * (gravity + (leg + ground_force_N(i)) / kFoot_kg);
      feet_[i] += h * speeds_[i];
    }
    const Eigen::Matrix3d inertia =
        rotation_ * Eigen::Vector3d{4.0, 11.0, 12.0}.asDiagonal() * rotation_.transpose();  // kg m^2
    velocity_ += h * force / kTrunk_kg;
    rate_ += h * (inertia.inverse() * (moment - rate_.cross(inertia * rate_)));
    place_ += h * velocity_;
    rotation_ = orthonormalised(rotation_by(h * rate_) * rotation_);
  }

  LocomotionParams params_;
  gait::RobotPlan plan_;
  Eigen::Vector3d place_ = Eigen::Vector3d::Zero(), velocity_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d rate_ = Eigen::Vector3d::Zero(), acceleration_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Identity();
  std::array<Eigen::Vector3d, kLegs> feet_, speeds_;
  LegTorques torques_ = [] {
    LegTorques zero;
    zero.fill(Eigen::Vector3d::Zero());
    return zero;
  }();
};

}  // namespace farrier::locomotion
