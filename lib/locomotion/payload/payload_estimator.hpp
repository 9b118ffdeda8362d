#pragma once

#include <Eigen/Core>

namespace farrier::locomotion {

/// Estimation of a load that the model does not know, and its use. Shares are of the model's mass.
struct PayloadParams {
  bool on = true;                       ///< false: the weight of the model alone is supported
  double time_constant_s = 0.4;         ///< memory of the balance of forces, > 0
  double moment_time_constant_s = 2.0;  ///< memory of the balance of moments, > 0
  double least_share = -0.3;            ///< lower limit of the mass that is used, > -1, <= 0: a trunk that is lighter
  double largest_share = 0.6;           ///< upper limit, >= 0
  double largest_rate_1_s = 0.6;        ///< of the share that is used, > 0
  double largest_shift_m = 0.1;         ///< of the centre of mass that is used, per axis, >= 0
  double largest_shift_rate_m_s = 0.1;  ///< > 0
  double push_gate_m_s2 = 2.0;          ///< a horizontal force per mass that the feet do not explain is a push, > 0
  double push_time_constant_s = 0.02;   ///< low-pass of that force, > 0
  double shortfall_gate_m_s2 = 1.0;     ///< a lift per mass that the feet were asked for and do not give, > 0
  double shortfall_time_constant_s = 0.4;  ///< low-pass of that lift, > 0
};

/// Forces of the ground on the robot and the motion that answers them at one tick. Trunk frame.
struct ForceBalance {
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();              ///< sum over the feet that stand
  Eigen::Vector3d moment_Nm = Eigen::Vector3d::Zero();            ///< of these forces about the trunk's origin
  Eigen::Vector3d specific_force_m_s2 = Eigen::Vector3d::Zero();  ///< of the IMU
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();                  ///< unit vector against gravity
  Eigen::Vector3d com_m = Eigen::Vector3d::Zero();                ///< centre of mass by the model
  double wanted_lift_N = 0.0;  ///< of these feet against gravity, by the command that `force_N` answers; 0: none
};

/// A load beside the model.
struct Payload {
  double mass_kg = 0.0;        ///< less than 0 if the robot is lighter than its model
  double mass_error_kg = 0.0;  ///< standard deviation of the mass over the last strides
  /// Mass times place, kg m, trunk axes. The part along gravity is zero: standing feet do not show it.
  Eigen::Vector3d moment_kgm = Eigen::Vector3d::Zero();
  double validity = 0.0;  ///< 0..1: share of the memory that holds measurements
};

/// Mass distribution that a controller assumes: the model's and a payload within limits.
struct AssumedMass {
  double mass_kg = 0.0;
  Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();  ///< of the centre of mass from the model's, trunk axes
};

/// Estimates a payload from the balance of force and moment (Newton, Euler) of a robot on its feet. The equations are
/// u.F = m u.s and M = (m_0 c_0 + d) x s. Force F and moment M are the ground's, s is the specific force and u points up.
/// Mass m_0 and centre c_0 are the model's, and d = sum m_i c_i the payload's. Forces are means over `time_constant_s`,
/// moments over `moment_time_constant_s`, in which the motion of legs and trunk cancels. The estimate rests in a push. It
/// rests while the feet give less than they are asked for, because a trunk that tilts for lack of a moment looks like
/// one with another centre of mass. Support for that would tilt it more. Forces along gravity alone decide on the mass,
/// so that a horizontal force does not.
class PayloadEstimator {
 public:
  PayloadEstimator(const PayloadParams& params, double mass_kg, double period_s) noexcept;

  /// Takes the balance of one tick of a robot that stands or walks. One beyond ten times gravity, or
  /// with a number that is not finite, is left out.
  void update(const ForceBalance& balance) noexcept;

  /// Moves the assumed mass towards the estimate. Call once per tick, also if there is no balance.
  void assume(const Eigen::Vector3d& com_m) noexcept;

  /// Forgets all: a robot that lies is loaded and unloaded without a trace.
  void reset() noexcept;

  const Payload& payload() const noexcept { return payload_; }
  const AssumedMass& assumed() const noexcept { return assumed_; }

 private:
  bool pushed(const ForceBalance& balance) noexcept;
  bool falls_short(const ForceBalance& balance) noexcept;

  PayloadParams params_;
  double mass_kg_;
  double period_s_;
  double force_N_, specific_force_m_s2_, slow_mass_kg_, variance_kg2_, shortfall_N_;
  Eigen::Vector3d moment_Nm_, direction_m_s2_, unexplained_N_;
  Payload payload_;
  AssumedMass assumed_;
};

}  // namespace farrier::locomotion
