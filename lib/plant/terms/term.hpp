#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "plant/actuator.hpp"
#include "plant/electric_actuator.hpp"

namespace farrier::plant {

/// Where an effect sits, as the load cell splits a joint, Hubacher (2014) (2.22).
enum class Side {
  kValveAndOil,     ///< left of the cell: from current and motion to force
  kLoad,            ///< right of it: from force to motion
  kForceSensor,     ///< the cell itself: shows on both sides
  kVelocitySensor,  ///< shows between position and velocity
  kDrive,           ///< motor and gear of an electric joint, left of its torque sensor
};

/// Unit of a parameter of an effect: fitted numbers are multiples of it and of order one.
enum class Scale {
  kOne,
  kCurrent,  ///< valve_current_max_A
  kForce,    ///< supply pressure times the larger area, N or Nm; of an electric joint its rated torque
  kLength,   ///< stroke, m or rad
  kSpeed,    ///< velocity_scale(), m/s or rad/s
  kSecond,
  kRate,           ///< 1/s
  kLeakage,        ///< full flow of the valve at supply pressure, per supply pressure, m^3/s/Pa
  kDroop,          ///< its inverse, Pa s/m^3
  kMass,           ///< of the nominal load
  kDamping,        ///< of the nominal load
  kStiffness,      ///< of the nominal load, or a fifth of kForce over kLength where it has none
  kCubic,          ///< kStiffness over kLength squared
  kRotor,          ///< rotor of an electric joint, kg m^2
  kGearStiffness,  ///< its spring, or plant::softest_rigid_spring_Nm_rad of a rigid drive
};

/// Range of a parameter.
struct ParameterRange {
  double low, high;
};

/// One number of an effect. Its value in a robot file, a report and JSON is `scale` times the fitted number, or over it
/// where `reciprocal`; the file's name carries the unit.
struct Parameter {
  const char* name;         ///< with the unit of a cylinder
  const char* rotary_name;  ///< with that of a motor
  const char* unit;
  const char* rotary_unit;
  Scale scale;
  bool reciprocal;
  double low, high;              ///< range of the fitted number
  std::array<double, 2> starts;  ///< where a fit begins; alike: once
  const char* meaning;
  bool held = false;  ///< a fit leaves it as the joint's file has it, or at its start

  /// Range of its value in multiples of the scale.
  constexpr ParameterRange multiples() const noexcept {
    return reciprocal ? ParameterRange{1.0 / high, 1.0 / low} : ParameterRange{low, high};
  }
};

/// Description of an effect. The first parameter says how large it is.
struct EffectInfo {
  const char* name;
  Side side;
  bool nominal;  ///< its neutral value is a parameter of the nominal joint: 3 % from it is no effect
  bool either_sign;
  std::span<const Parameter> parameters;
  const char* meaning;  ///< a sentence, for reports
  /// True if the plant has a state of it: in a class of plant/effects, the delay line or the joint. But for the joint's
  /// the term's own code, which steps from sample to sample, is then for fits alone.
  bool has_state = false;
  /// Name of the effect that is a special case of this one, or null. The parameters begin with those of it. A diagnosis
  /// names this one in its place alone, where that explains less.
  const char* special_case = nullptr;
};

/// Sizes that make the parameters of a joint's effects comparable.
class Scales {
 public:
  Scales(const ActuatorParams& actuator, const LoadParams& load) noexcept : load_(load) {
    const double full_flow =
        actuator.valve_gain * actuator.valve_current_max_A * std::sqrt(actuator.supply_pressure_Pa);
    const double area = actuator.area_a > actuator.area_b ? actuator.area_a : actuator.area_b;
    const double force = actuator.supply_pressure_Pa * area;
    const double stiffness = load.stiffness > 0.0 ? load.stiffness : 0.2 * force / actuator.stroke;
    sizes_ = {1.0,
              actuator.valve_current_max_A,
              force,
              actuator.stroke,
              velocity_scale(actuator),
              1.0,
              1.0,
              full_flow / actuator.supply_pressure_Pa,
              actuator.supply_pressure_Pa / full_flow,
              load.mass,
              load.damping > 0.0 ? load.damping : 0.01 * force / velocity_scale(actuator),
              stiffness,
              stiffness / (actuator.stroke * actuator.stroke)};
  }

  /// Sizes of an electric joint. `rated_torque_Nm` > 0.
  Scales(const ElectricParams& drive, const LoadParams& load, double rated_torque_Nm) noexcept
      : load_(load), gear_neutral_(drive.rigid ? 0.0 : 1.0) {
    const double speed = no_load_speed(drive);
    const double stiffness = load.stiffness > 0.0 ? load.stiffness : 0.2 * rated_torque_Nm / drive.travel;
    sizes_ = {1.0,
              current_max_A(drive),
              rated_torque_Nm,
              drive.travel,
              speed,
              1.0,
              1.0,
              1.0,
              1.0,
              load.mass,
              load.damping > 0.0 ? load.damping : 0.01 * rated_torque_Nm / speed,
              stiffness,
              stiffness / (drive.travel * drive.travel),
              drive.rotor_inertia_kg_m2,
              drive.rigid ? softest_rigid_spring_Nm_rad(drive) : drive.spring_stiffness};
  }

  double of(Scale scale) const noexcept { return sizes_[static_cast<std::size_t>(scale)]; }
  /// Fitted number at which a parameter changes nothing.
  double neutral(const Parameter& parameter) const noexcept {
    switch (parameter.scale) {
      case Scale::kMass:
      case Scale::kRotor:
        return 1.0;
      case Scale::kGearStiffness:
        return gear_neutral_;
      case Scale::kDamping:
        return load_.damping / of(Scale::kDamping);
      case Scale::kStiffness:
        return load_.stiffness / of(Scale::kStiffness);
      default:
        return parameter.scale == Scale::kOne && parameter.low > 0.0 ? 1.0 : 0.0;
    }
  }
  double value(const Parameter& parameter, double fitted) const noexcept {
    return parameter.reciprocal ? of(parameter.scale) / fitted : of(parameter.scale) * fitted;
  }
  double fitted(const Parameter& parameter, double value) const noexcept {
    return parameter.reciprocal ? of(parameter.scale) / value : value / of(parameter.scale);
  }

 private:
  LoadParams load_;
  double gear_neutral_ = 0.0;
  std::array<double, 15> sizes_{};
};

// Values that the terms of a joint read and change. T is double, or a number that carries derivatives; all values in
// SI, actuator coordinates. A term is a class template with one constructor (the fitted numbers of its parameters,
// scales, step) and the hooks below that it needs; it holds its own state.

/// on_valve: the way of the current to the ports, over one substep.
template <class T>
struct ValveMoment {
  T opening_A;    ///< the command's mean, then the current that opens the ports
  T flow_factor;  ///< on the valve gain
};

/// on_oil: at the beginning of a substep.
template <class T>
struct OilMoment {
  T pressure_a_Pa, pressure_b_Pa;
  T supply_flow_m3_s;      ///< drawn from the supply a substep earlier
  double hydraulic_force;  ///< N or Nm
  double bulk_modulus_Pa;
  T supply_pressure_Pa;
  T leakage_m3_s;            ///< from a to b
  T softness_a, softness_b;  ///< 1/beta beyond the oil's own, 1/Pa
  T play_slope;              ///< d(piston - load)/d(force), m/N
  double return_pressure_Pa = 0.0;
  T into_a_m3_s = T(0.0), into_b_m3_s = T(0.0);  ///< past the valve's closed lands, into the chambers
  T past_lands_m3_s = T(0.0);                    ///< and from the supply
};

/// on_play: the piston beside the load over one substep.
template <class T>
struct PlayMoment {
  T drive;      ///< force that would reach the load if the piston did not move against it
  T damping;    ///< of the piston
  T stiffness;  ///< of the oil
  double step_s;
  T moved;  ///< travel of the piston beyond the load's
};

/// on_piston: the part of the hydraulic force that does not reach the load cell, at a sample.
template <class T>
struct PistonMoment {
  double position, velocity;
  double period_s;
  T force;  ///< N or Nm, on the piston, positive along +position
};

/// on_load: forces on the load over one substep, written in its mean velocity w: hold + slope w holds it back.
template <class T>
struct LoadMoment {
  T position, velocity;  ///< of the load: middle of the substep, beginning of it
  T mass, damping, stiffness, slack_position;
  T external_force;
  T hold, slope;
};

/// on_force: the load cell's reading of a force, at a sample.
template <class T>
struct ForceMoment {
  T force;  ///< true, then read
};

}  // namespace farrier::plant
