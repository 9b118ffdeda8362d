#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "diagnosis/model/constants.hpp"
#include "diagnosis/model/model.hpp"
#include "plant/electric_actuator.hpp"
#include "plant/terms/active_effect.hpp"
#include "plant/terms/load_friction.hpp"

namespace farrier::diagnosis {

/// Places of the nominal factors of an electric joint; those of its load are Nominal's.
enum class DriveNominal { kTorqueConstant, kResistance, kInductance, kRotor, kStiffness, kDamping, kCoulomb, kLag };

/// An electric joint with a model's factors and effects, seen at the gear's output, SI. Symbols as in
/// plant/electric_actuator.hpp.
template <class T>
struct DriveNumbers {
  bool rigid;
  T reading_Nm_A;  ///< torque that a rigid drive believes to have per current: N K of the file
  T constant;      ///< N K
  T resistance, inductance;
  T rotor;  ///< J N^2
  T damping, coulomb;
  T stiffness, relaxation;  ///< k, and b; of the gear of a rigid drive if `elastic`
  bool elastic;             ///< rotor and load of a rigid drive are two
  T lag_s;                  ///< of a rigid drive's current; of another drive's command, 0 for none
  double slip_velocity, voltage_V, most_A;
  T limit_A;    ///< of the command
  T half_play;  ///< of the gear
  bool plays;
  bool cogs;
  T cogging, periods_per_turn, phase_rad;
  bool hangs;
  T moment, hanging_rad;
  std::optional<plant::LoadFriction<T>> gear_friction;

  T cogging_torque(const T& position) const {
    using std::sin;
    return cogs ? T(cogging * sin(periods_per_turn * position + phase_rad)) : T(0.0);
  }
};

/// The command within the drive's limits, at a speed of the load.
template <class T>
T admitted(const DriveNumbers<T>& n, const T& command_A, double speed) {
  if (!n.rigid) {
    return command_A > n.limit_A ? n.limit_A : command_A < -n.limit_A ? T(-n.limit_A) : command_A;
  }
  // R u + N K v within +-V_max
  const double ohm = value_of(n.resistance);
  const double back_V = value_of(n.reading_Nm_A) * speed;
  const double high = std::clamp((n.voltage_V - back_V) / ohm, -n.most_A, n.most_A);
  const double low = std::clamp((-n.voltage_V - back_V) / ohm, -n.most_A, n.most_A);
  const T most = n.limit_A < high ? n.limit_A : T(high);
  const T least = -n.limit_A > low ? T(-n.limit_A) : T(low);
  return command_A > most ? most : command_A < least ? least : command_A;
}

/// Torque of gear and spring over a step of the mean speeds w of the rotor and v of the load: base + slope (w - v).
template <class T>
struct GearStep {
  T base, slope;
};

/// Torque k delta of a spring with play, delta outside of it.
template <class T>
T spring_torque(const DriveNumbers<T>& n, const T& bent) {
  if (!n.plays) {
    return n.stiffness * bent;
  }
  return bent > n.half_play    ? T(n.stiffness * (bent - n.half_play))
         : bent < -n.half_play ? T(n.stiffness * (bent + n.half_play))
                               : T(0.0);
}
template <class T>
bool touches(const DriveNumbers<T>& n, const T& bent) {
  return !n.plays || bent > n.half_play || bent < -n.half_play;
}

/// Slope of the torque of gear and spring over a step where it touches.
template <class T>
T gear_slope(const DriveNumbers<T>& n, double step_s) {
  return 0.5 * step_s * n.stiffness + n.relaxation;
}

/// The midpoint rule, linear about the bend that the speed apart, w - v, now leads to amid the step. `slope` is gear_slope().
template <class T>
GearStep<T> gear_step(const DriveNumbers<T>& n, const T& bent, double apart, double step_s, const T& slope) {
  if (!n.plays) {
    return {n.stiffness * bent, slope};
  }
  const double middle = value_of(bent) + 0.5 * step_s * apart;
  const double half_play = value_of(n.half_play);
  return middle > half_play    ? GearStep<T>{n.stiffness * (bent - n.half_play), slope}
         : middle < -half_play ? GearStep<T>{n.stiffness * (bent + n.half_play), slope}
                               : GearStep<T>{T(0.0), T(0.0)};
}

/// Dry friction T_c phi of the file over a step: hold + slope w, linear about the speed now. With phi = w / sqrt(w^2 + s^2),
/// the derivatives are phi' = s^2 / (w^2 + s^2)^1.5 and phi'' = -3 w phi' / (w^2 + s^2).
template <class T>
GearStep<T> dry_step(const DriveNumbers<T>& n, const T& speed) {
  const double coulomb = value_of(n.coulomb);
  if (coulomb == 0.0) {
    return {T(0.0), T(0.0)};
  }
  const double w = value_of(speed);
  const double s = n.slip_velocity;
  const double square = w * w + s * s;
  const double root = std::sqrt(square);
  const double steep = s * s / (square * root);
  const double bend = -3.0 * w * steep / square;
  const double hold = w / root - steep * w;
  return {chained(coulomb * hold, -coulomb * w * bend, speed, hold, n.coulomb),
          chained(coulomb * steep, coulomb * bend, speed, steep, n.coulomb)};
}

/// Scale on gear_stiffness at which a rigid drive with play meets its flanks: 400 Hz of the rotor.
inline constexpr double kFlankStiffness = 16.0;
/// Damping over stiffness of the flanks, s.
inline constexpr double kFlankRelaxation_s = 2e-4;

template <class T>
DriveNumbers<T> drive_numbers(const plant::ElectricParams& a, const plant::Scales& scales,
                              const std::array<T, kNominals>& factors, const EffectNumbers<T>& effects, double step_s) {
  const auto nominal = [&](DriveNominal place) -> const T& { return factors[static_cast<std::size_t>(place)]; };
  const double constant = a.gear_ratio * a.torque_constant_Nm_A;
  DriveNumbers<T> n{};
  n.rigid = a.rigid;
  n.reading_Nm_A = T(constant);
  n.constant = nominal(DriveNominal::kTorqueConstant) * constant;
  n.resistance = nominal(DriveNominal::kResistance) * a.winding_resistance_Ohm;
  n.inductance = nominal(DriveNominal::kInductance) * a.winding_inductance_H;
  n.rotor = nominal(DriveNominal::kRotor) * plant::armature_kg_m2(a);
  n.damping = nominal(DriveNominal::kDamping) * a.damping;
  n.coulomb = nominal(DriveNominal::kCoulomb) * a.coulomb;
  n.stiffness = nominal(DriveNominal::kStiffness) * a.spring_stiffness;
  n.relaxation = T(a.spring_damping);
  n.lag_s = a.rigid ? T(nominal(DriveNominal::kLag) * a.torque_time_constant_s) : T(0.0);
  n.slip_velocity = a.slip_velocity;
  n.voltage_V = a.supply_voltage_V;
  n.most_A = plant::current_max_A(a);
  n.limit_A = T(n.most_A);
  for (const auto& [id, fitted] : effects) {
    const std::string_view name = plant::effect_info(id).name;
    const auto value = [&, id = id, &fitted = fitted](std::size_t i) -> T {
      const plant::Parameter& p = plant::effect_info(id).parameters[i];
      return p.reciprocal ? T(scales.of(p.scale) / fitted[i]) : T(scales.of(p.scale) * fitted[i]);
    };
    if (name == "torque_constant") {
      n.constant *= value(0);
    } else if (name == "current_lag") {
      n.lag_s += value(0);
    } else if (name == "current_limit") {
      n.limit_A = value(0);
    } else if (name == "rotor_inertia") {
      n.rotor = value(0) * (a.gear_ratio * a.gear_ratio);
    } else if (name == "gear_stiffness") {
      n.stiffness = value(0);
      n.relaxation = a.rigid ? T(value(0) * value(1)) : n.relaxation;
      n.elastic = a.rigid;
    } else if (name == "gear_friction") {
      n.gear_friction.emplace(fitted.data(), scales, step_s);
    } else if (name == "backlash") {
      n.plays = true;
      n.half_play = 0.5 * value(0);
    } else if (name == "cogging") {
      n.cogs = true;
      n.cogging = value(0);
      n.periods_per_turn = value(1);
      n.phase_rad = value(2);
    } else if (name == "gravity") {
      n.hangs = true;
      n.moment = value(0);
      n.hanging_rad = value(1);
    }
  }
  if (a.rigid && n.plays && !n.elastic) {
    n.elastic = true;
    n.stiffness = T(kFlankStiffness * scales.of(plant::Scale::kGearStiffness));
    n.relaxation = kFlankRelaxation_s * n.stiffness;
  }
  return n;
}

}  // namespace farrier::diagnosis
