#pragma once

#include <optional>
#include <string>

#include "core/result.hpp"
#include "plant/actuator.hpp"
#include "plant/linkage.hpp"
#include "locomotion/supply_guard.hpp"
#include "plant/supply.hpp"
#include "robot/robot.hpp"

namespace farrier::robot {

// Derived quantities, one function each. Values that a rotary motor's data sheet does not give come from a cylinder
// whose force F would act on a lever r: torque r F, angle x / r. Friction and inertia therefore scale with r^2, noise
// and normalisation of position and velocity with 1 / r, of force with r.

/// The linkage of a leg that counts angles like a hind one (mirrored false) or the other way.
Result<plant::Linkage> make_linkage(const LinkageSection& section, bool mirrored);

/// A_p = pi D_p^2 / 4 and A_r = pi (D_p^2 - D_r^2) / 4 (Hubacher 2014, Table A.1); the rest is copied.
plant::ActuatorParams cylinder_params(const Supply& supply, const Valve& valve, const Actuator& actuator);

/// Friction, rotor inertia and stops are those of `like` times r^2.
plant::ActuatorParams motor_params(const Supply& supply, const Valve& valve, const Actuator& actuator,
                                   const Cylinder& like, double lever_m);

plant::LoadParams cylinder_load(const CylinderLoad& load);

/// The leg as the load of a motor: its inertia, and the viscous friction of a cylinder's load times r^2, its dry friction times r.
plant::LoadParams leg_load(double inertia_kg_m2, const CylinderLoad& damping_like, double lever_m);

/// The supply that all joints share; none without a pump.
std::optional<plant::SupplyParams> supply_params(const RobotFile& file);

/// Limits of that supply; none without a pump.
std::optional<locomotion::SupplyGuardParams> supply_guard_params(const RobotFile& file);

/// Largest force (N or Nm), the smaller of the supply's and the actuator's rated one: push p_s A_a - p_t A_b, pull p_s
/// A_b - p_t A_a.
struct ForceLimits {
  double push;
  double pull;
};
ForceLimits force_limits(const plant::ActuatorParams& actuator, double rated);

SensorNoise cylinder_noise(const CylinderNoise& noise);
SensorNoise motor_noise(const CylinderNoise& noise, double lever_m);

/// Sensors as seen on a lever (1 for a cylinder): the filters are those of the section, the steps are divided by the
/// lever.
Sensors sensors(const std::optional<SensorSection>& section, double lever);

/// T = W of (3.52): half the stroke, velocity and force by the file; V of (3.53) is the full-open valve's current.
control::Normalisation cylinder_normalisation(const Cylinder& cylinder, const plant::ActuatorParams& params);

/// Half the travel; the cylinder's velocity divided by the lever and its force multiplied by it. One set of weights
/// then asks the same of a hip and a knee: equal power, equal stiffness of the loop at the leg.
control::Normalisation motor_normalisation(const Cylinder& like, const plant::ActuatorParams& params, double lever_m);

/// Motor, gear and spring of an electric actuator. One known by its limits is rigid, likewise one without a spring or
/// with a rigid one.
plant::ElectricParams electric_params(const ElectricActuator& actuator);

/// Stiffnesses between which a spring suits no model, Nm/rad, see electric_actuator.hpp; `softest_rigid` may be the
/// smaller one. The actuator has a motor's values.
struct SpringLimits {
  double stiffest;
  double softest_rigid;
};
SpringLimits spring_limits(const ElectricActuator& actuator);
/// True if the actuator has a spring so stiff that the drive counts as rigid.
bool spring_is_rigid(const ElectricActuator& actuator);

/// The sentence that says which springs of the file are so stiff that their drives count as rigid; empty for none.
std::string rigid_spring_note(const RobotFile& file);

/// That of the file, or the largest torque of the drive, Nm.
double rated_torque_Nm(const ElectricActuator& actuator);

/// Sets the fields of a joint that follow from an electric actuator and its loads. T = W of (3.52): half the travel,
/// velocity and torque by the file; V of (3.53) is the largest current of its drive. Torques up to the rated or stall
/// torque.
void drive_electrically(Joint& joint, const ElectricActuator& actuator, const RotaryLoads& loads);

}  // namespace farrier::robot
