#pragma once

#include "core/result.hpp"

namespace farrier::plant {

/// Triangle of a cylinder across a revolute joint: sides a and b are fixed to the two links and enclose
/// angle_at_zero_rad + angle_sign * mirror * q; the cylinder is the third side.
struct TriangleParams {
  double side_a_m = 0.0;            ///< > 0
  double side_b_m = 0.0;            ///< > 0
  double angle_at_zero_rad = 0.0;   ///< angle between the sides at q = 0, in (0, pi)
  double angle_sign = 1.0;          ///< +1 when positive q opens the triangle on an unmirrored leg, else -1
  double mirror = 1.0;              ///< -1 for legs that count q the other way, else +1
  double retracted_length_m = 0.0;  ///< cylinder length at position 0; > 0
};

/// Geometry between joint angle q (rad; or whatever a direct linkage is given) and actuator position (m or rad,
/// from retracted). Powers agree on both sides: velocity = lever qdot, torque = lever force.
class Linkage {
 public:
  /// Law of cosines; refuses non-physical values, naming each.
  static Result<Linkage> triangle(const TriangleParams& params);

  /// position = lever (q - offset): lever 1 and the motor's zero for a rotary motor, lever 1 and offset 0 for a rig
  /// whose joint is its piston. `lever` must not be 0 (checked invariant).
  static Linkage direct(double lever, double offset);

  /// Actuator position at q. On a triangle q must keep the enclosed angle in (0, pi), where it is monotonous.
  double position(double q) const noexcept;
  /// d position / dq, signed; m/rad, or 1 on a direct linkage.
  double lever(double q) const noexcept;
  /// d lever / dq; m/rad^2.
  double lever_slope(double q) const noexcept;
  /// Inverse of position(); positions out of the triangle's reach give the nearer end.
  double angle(double position) const noexcept;
  /// qdot = velocity / lever(q); 0 at a dead centre, where the actuator's velocity does not fix the joint's.
  double angular_velocity(double q, double velocity) const noexcept;
  /// tau = lever(q) force.
  double torque(double q, double force) const noexcept { return lever(q) * force; }
  /// Actuator force that gives `torque`; 0 at a dead centre.
  double force(double q, double torque) const noexcept;

 private:
  explicit Linkage(const TriangleParams& params) noexcept;
  Linkage(double lever, double offset) noexcept : is_direct_(true), direct_lever_(lever), offset_(offset) {}

  struct Side {
    double length;  ///< c
    double sine;
    double cosine;
  };
  Side third_side(double q) const noexcept;

  bool is_direct_ = false;
  double direct_lever_ = 1.0;
  double offset_ = 0.0;
  double angle_at_zero_ = 0.0;
  double sign_ = 1.0;
  double squares_ = 0.0;      ///< a^2 + b^2
  double two_ab_ = 0.0;       ///< 2 a b
  double retracted_ = 0.0;
  double dead_lever_ = 0.0;   ///< levers shorter than this are a dead centre
};

}  // namespace farrier::plant
