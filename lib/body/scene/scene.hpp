#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "body/dynamics/rigid_body.hpp"
#include "body/model/body_model.hpp"
#include "body/model/body_state.hpp"
#include "core/result.hpp"

namespace farrier::body {

/// A box that does not move.
struct Box {
  std::string name;
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_extents_m = Eigen::Vector3d::Zero();      ///< each > 0
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< from the box's axes to the world's
  std::string origin{};  ///< file and line that it comes from, before a refusal; empty for none
};

/// A constant force at the trunk's centre of mass.
struct Push {
  std::string name;
  double start_s = 0.0;                                  ///< >= 0
  double duration_s = 0.0;                               ///< > 0
  Eigen::Vector3d impulse_Ns = Eigen::Vector3d::Zero();  ///< force times duration, in the world's axes
};

/// A point mass that sits on the trunk from a time on.
struct Payload {
  std::string name;
  double start_s = 0.0;                                  ///< >= 0
  double mass_kg = 0.0;                                  ///< > 0
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< in the trunk's frame
};

/// A fault of the hydraulic supply from a time on. The body does not know of it; its actuators do.
struct SupplyChange {
  std::string name;
  double start_s = 0.0;                                        ///< >= 0
  std::optional<double> pump_flow_m3_s = std::nullopt;         ///< >= 0; none leaves it
  std::optional<double> accumulator_volume_m3 = std::nullopt;  ///< of the gas at its precharge, >= 0; none leaves it
  std::string origin{};  ///< file and line that it comes from, before a refusal; empty for none
};

/// A change of hydraulic actuators from a time on: wear, heat, or a fault of the valve. The body does not know of it.
/// An absent value stays as it was.
struct ActuatorChange {
  std::string name{};
  std::string joint{};      ///< empty: of all joints
  double start_s = 0.0;     ///< >= 0
  double duration_s = 0.0;  ///< over which it grows evenly, >= 0
  // Factors on what the robot file has:
  std::optional<double> valve_gain = std::nullopt;     ///< > 0
  std::optional<double> bulk_modulus = std::nullopt;   ///< > 0
  std::optional<double> viscosity = std::nullopt;      ///< of the piston's viscous friction, >= 0
  std::optional<double> seal_friction = std::nullopt;  ///< >= 0
  // Values:
  std::optional<double> leakage_m3_s_Pa = std::nullopt;  ///< between the chambers, beside the file's, >= 0
  std::optional<double> overlap_A = std::nullopt;        ///< of the valve, >= 0
  std::optional<double> stuck_A = std::nullopt;          ///< current for which the spool stays open whatever is sent
  std::string origin{};  ///< file and line that it comes from, before a refusal; empty for none
};

/// The robot's surroundings: a plane through the world's origin, boxes, what acts on the trunk, and changes of the supply
/// and of actuators.
struct Scene {
  double friction = 0.8;                                       ///< Coulomb, of feet on everything; >= 0
  Eigen::Quaterniond ground = Eigen::Quaterniond::Identity();  ///< turns the world's z to the plane's normal
  std::vector<Box> boxes;
  std::vector<Push> pushes;
  std::vector<Payload> payloads;
  std::vector<SupplyChange> supply_changes;
  std::vector<ActuatorChange> actuator_changes;
};

/// Refuses ranges that no engine can simulate, by the name of the part.
Result<Done> validate(const Scene& scene);

/// Refuses a start with a foot in a box or in the plane, by the names of both and the line of the box. `body` has the state of the start.
Result<Done> check_start(const Scene& scene, const BodyModel& model, const RigidBody& body);

/// Mean force of all pushes from one time to a later one. Summed over a run it gives each impulse, wherever ticks fall.
Eigen::Vector3d push_force_N(const Scene& scene, double from_s, double to_s) noexcept;

/// The trunk with all payloads that have started at that time.
RigidInertia loaded_trunk(const RigidInertia& trunk, const Scene& scene, double time_s) noexcept;

/// A rotation by yaw, then pitch, then roll about the moved axes, from our own sine and cosine. Angles in [-8, 8] rad.
Eigen::Quaterniond attitude_of(double roll_rad, double pitch_rad, double yaw_rad) noexcept;

}  // namespace farrier::body
