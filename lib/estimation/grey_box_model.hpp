#pragma once

// The nonlinear joint with its unknowns and how it answers to each of them: what the grey-box filter predicts with.

#include <Eigen/Core>

#include "plant/actuator.hpp"
#include "plant/equations.hpp"
#include "plant/joint_physics.hpp"

namespace farrier::estimation {

inline constexpr int kMotions = 4;
inline constexpr int kUnknowns = 8;
inline constexpr int kGreyBoxStates = kMotions + kUnknowns;

/// Position and velocity (m, m/s or rad, rad/s) and the compressions of both chambers (Pa, plant::IntegrationState).
using Motion = Eigen::Vector4d;
/// In the order of plant::JointPhysics: ln m_l, ln d_l, F_c, C, F_bias, ln (K_v / nominal), ln (beta_e / nominal),
/// leakage. Logarithms keep positive what is positive and make a start a hundred times wrong one like any other.
using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
/// Places in Unknowns.
enum Unknown : int { kMass, kDamping, kCoulomb, kStiffness, kBias, kValveGain, kBulkModulus, kLeakage };
/// Derivative of one number with respect to motion and unknowns.
using Gradient = Eigen::Matrix<double, kGreyBoxStates, 1>;
/// Column i: gradient of motion i.
using Sensitivity = Eigen::Matrix<double, kGreyBoxStates, kMotions>;

/// Right-hand side of plant::JointEquations with Coulomb friction of load and seals, leakage and a bias force added, and its derivatives.
/// docs/derivations/grey-box.md has them.
class GreyBoxModel {
 public:
  /// Where a tick takes a motion, and how that depends on where it began and on the unknowns.
  struct Passage {
    Motion motion;
    Sensitivity by;
    double inverse_mass;  ///< 1 / (m_l + m_p)
    bool bent;            ///< met an end stop or a void, where the derivatives say little
  };
  struct Force {
    double value;  ///< N or Nm
    Gradient by;
  };

  /// `actuator` passes plant::validate; `equilibrium_position` as in plant::LoadParams; Coulomb friction turns over
  /// smoothly within `slip_velocity` (m/s or rad/s; > 0). `seal_friction` is the piston's, left of the load cell, known
  /// (N or Nm; >= 0).
  GreyBoxModel(const plant::ActuatorParams& actuator, double equilibrium_position, double slip_velocity,
               double seal_friction = 0.0) noexcept
      : actuator_(actuator),
        equilibrium_position_(equilibrium_position),
        slip_velocity_(slip_velocity),
        seal_friction_(seal_friction) {}

  /// A tick with the current held. Fourth-order Runge-Kutta, at most kMostSubsteps of them, on motion and sensitivity
  /// alike, so that the second is the first's exact derivative.
  Passage pass(const Motion& from, const Unknowns& unknowns, double current_A, double period_s) const noexcept;

  /// F_s = F_h + F_stop - d_p v - F_p sign(v) - m_p a, (2.22) left side with the seals' friction F_p.
  Force load_cell_force(const Motion& at, const Unknowns& unknowns) const noexcept;

  /// Motion that a measured position, velocity and force speak for when the valve is slow: (3.19), (3.20), mean of
  /// both signs.
  Motion at_rest(const Eigen::Vector3d& measured) const noexcept;

  Unknowns unknowns_of(const plant::JointPhysics& physics) const noexcept;
  plant::JointPhysics physics_of(const Unknowns& unknowns) const noexcept;

  const plant::ActuatorParams& actuator() const noexcept { return actuator_; }
  double equilibrium_position() const noexcept { return equilibrium_position_; }

  static constexpr int kMostSubsteps = 48;

  /// d motion / dt with its derivatives; entries that are always 0 are left out.
  struct Rate {
    Motion value;
    Eigen::Vector4d velocity_by;          ///< of the acceleration, by motion
    Eigen::Matrix<double, 5, 1> load_by;  ///< of the acceleration, by the first five unknowns
    Eigen::Vector4d a_by, b_by;           ///< of the chambers' rates, by motion
    Eigen::Vector3d a_by_oil, b_by_oil;   ///< and by the last three unknowns
    double stop_force, stop_by_position, stop_by_velocity;
    double seal_force, seal_by_velocity;  ///< of the seals, against the motion
  };
  Rate rate(const Motion& at, const plant::JointPhysics& physics, double current_A) const noexcept;

 private:
  void add_load(Rate& r, const Motion& at, const plant::JointPhysics& physics) const noexcept;
  void add_oil(Rate& r, const Motion& at, const plant::JointPhysics& physics, double current_A) const noexcept;

  plant::ActuatorParams actuator_;
  double equilibrium_position_;
  double slip_velocity_;
  double seal_friction_;
};

}  // namespace farrier::estimation
