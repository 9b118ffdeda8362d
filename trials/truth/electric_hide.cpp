#include "trials/truth/electric_hide.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace farrier::truth::electric {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;

// Torques are relative to the rating, or to the run's where that is far less.
double torque_unit(const Extents& e) { return std::min(e.rated_Nm, 6.0 * e.rms_torque); }

// Multiplied or divided, by chance.
double times(double value, double factor, const Chance& chance) {
  const double f = 1.0 + (factor - 1.0) * chance.spread();
  return chance.sign() > 0.0 ? value * f : value / f;
}

// Greased steel: Stribeck velocity of 0.05 rad/s, bristles of a third of a milliradian.
Contact dry(double coulomb, double inertia, const Chance& chance) {
  Contact c;
  c.coulomb = coulomb;
  c.breakaway = coulomb * chance.within(1.2, 1.6);
  c.stribeck_velocity = 0.05;
  c.presliding = 3e-4;
  c.bristle_damping = 0.4 * std::sqrt(c.breakaway / c.presliding * inertia);
  return c;
}

double input_delay(ElectricMachine& m, double size_s, const Extents& e, const Chance& c) {
  long parts = std::lround(50.0 * size_s * c.spread() / e.period_s);
  parts += std::clamp(5L - parts % 50, 0L, 5L) - std::clamp(parts % 50 - 45L, 0L, 5L);
  return m.delay_s = static_cast<double>(parts) * e.period_s / 50.0;
}
double current_lag(ElectricMachine& m, double size_s, const Extents&, const Chance& c) {
  return m.command_lag_s = size_s * c.spread();
}
double current_limit(ElectricMachine& m, double share, const Extents& e, const Chance& c) {
  return m.limit_A = share * c.spread() * e.peak_A;
}
double torque_constant(ElectricMachine& m, double size, const Extents&, const Chance& c) {
  m.motor_constant_Nm_A *= 1.0 + size * c.spread() * c.sign();
  return m.gear_ratio * m.motor_constant_Nm_A / m.assumed_constant_Nm_A;
}
double rotor_inertia(ElectricMachine& m, double factor, const Extents&, const Chance& c) {
  m.rotor = times(m.rotor, factor, c);
  return m.rotor / (m.gear_ratio * m.gear_ratio);
}
// A drive with a spring has another one. In a rigid drive the rotor swings against the load at `size` Hz.
double gear_stiffness(ElectricMachine& m, double size, const Extents&, const Chance& c) {
  if (!m.rigid) {
    const double factor = size > 45.0 ? 1.25 : size > 25.0 ? 1.6 : 2.5;
    return m.spring = times(m.spring, factor, c);
  }
  const double both = m.rotor * m.load / (m.rotor + m.load);
  const double omega = kFullTurn * size * c.spread();
  m.gear_stiffness = both * omega * omega;
  m.gear_damping = 2.0 * c.within(0.03, 0.08) * both * omega;
  return m.gear_stiffness;
}
double gear_friction(ElectricMachine& m, double size, const Extents& e, const Chance& c) {
  m.gear_contact = dry(size * c.spread() * torque_unit(e), m.rotor, c);
  return m.gear_contact.coulomb;
}
double load_friction(ElectricMachine& m, double size, const Extents& e, const Chance& c) {
  m.load_contact = dry(size * c.spread() * torque_unit(e), m.load, c);
  return m.load_contact.coulomb;
}
// 12 to 120 periods in a turn of the output: poles of a motor times a low gear, or waves of a strain gear.
double cogging(ElectricMachine& m, double size, const Extents& e, const Chance& c) {
  m.ripple_periods = std::round(12.0 * std::pow(10.0, c.within(0.0, 1.0)));
  m.ripple_phase = kFullTurn * c.spread();
  return m.ripple_Nm = size * c.spread() * torque_unit(e);
}
double backlash(ElectricMachine& m, double size_rad, const Extents&, const Chance& c) {
  if (m.rigid) {
    const double both = m.rotor * m.load / (m.rotor + m.load);
    const double omega = kFullTurn * 250.0;
    m.gear_stiffness = both * omega * omega;
    m.gear_damping = 2.0 * 0.2 * both * omega;
  }
  return m.play = size_rad * c.spread();
}
double load_mass(ElectricMachine& m, double factor, const Extents&, const Chance& c) {
  return m.load = times(m.load, factor, c);
}
double load_damping(ElectricMachine& m, double factor, const Extents&, const Chance& c) {
  return m.load_damping = times(m.load_damping, factor, c);
}
double load_stiffness(ElectricMachine& m, double factor, const Extents& e, const Chance& c) {
  if (m.load_spring > 0.0) {
    return m.load_spring = times(m.load_spring, factor, c);
  }
  return m.load_spring = 0.5 * (factor - 1.0) * c.spread() * e.rms_torque / e.rms_motion;
}
double spring_hardening(ElectricMachine& m, double size, const Extents& e, const Chance& c) {
  const double cube = e.excursion * e.excursion * e.excursion;
  return m.cubic_spring = size * c.spread() * (m.load_spring > 0.0 ? m.load_spring * e.excursion : e.rms_torque) / cube;
}
double external_force(ElectricMachine& m, double size, const Extents& e, const Chance& c) {
  return m.external_torque = size * c.spread() * c.sign() * torque_unit(e);
}
double gravity(ElectricMachine& m, double size, const Extents& e, const Chance& c) {
  m.hanging = 0.5 * m.travel + c.sign() * c.within(0.3, 1.5);
  return m.weight_Nm = size * c.spread() * torque_unit(e);
}
double force_sensor_lag(ElectricMachine& m, double size_s, const Extents&, const Chance& c) {
  return m.sensor_lag_s = size_s * c.spread();
}
double force_sensor_gain(ElectricMachine& m, double size, const Extents&, const Chance& c) {
  return m.sensor_gain = 1.0 + size * c.spread() * c.sign();
}
double force_sensor_offset(ElectricMachine& m, double size, const Extents& e, const Chance& c) {
  return m.sensor_offset = size * c.spread() * c.sign() * torque_unit(e);
}
double velocity_filter_lag(ElectricMachine& m, double size_s, const Extents&, const Chance& c) {
  return m.velocity_lag_s = size_s * c.spread();
}

double position_dependent_friction(ElectricMachine& m, double size, const Extents& e, const Chance& c) {
  m.load_contact = dry(size * c.spread() * torque_unit(e), m.load, c);
  m.load_contact.presliding *= 4.0;
  m.load_contact.waviness = 0.75;
  m.load_contact.wavelength = 0.67 * e.excursion;
  return m.load_contact.coulomb;
}
// A winding that heats and a magnet that weakens: the torque per current falls while it runs.
double torque_fade(ElectricMachine& m, double size, const Extents& e, const Chance& c) {
  const double lost = size * c.spread();
  m.fade_per_s = lost / e.duration_s;
  return lost;
}
double flexible_load(ElectricMachine& m, double size, const Extents&, const Chance& c) {
  const double share = size * c.spread();
  const double omega = kFullTurn * c.within(8.0, 20.0);
  m.branch = share * m.load;
  m.branch_spring = m.branch * omega * omega;
  m.branch_damping = 2.0 * 0.05 * m.branch * omega;
  return share;
}
double periodic_load_force(ElectricMachine& m, double size, const Extents& e, const Chance& c) {
  m.beat_rad_s = kFullTurn * c.within(3.0, 12.0);
  return m.beat_Nm = size * c.spread() * torque_unit(e);
}
double random_disturbance_force(ElectricMachine& m, double size, const Extents& e, const Chance& c) {
  return m.random_Nm = size * c.spread() * torque_unit(e);
}
double command_dropouts(ElectricMachine& m, double size, const Extents&, const Chance& c) {
  return m.dropout = size * c.spread();
}

constexpr Entry kKnown[] = {
    {"input_delay", "delay_s", true, true, {0.0015, 0.003, 0.006}, input_delay},
    {"current_lag", "time_constant_s", true, true, {0.0015, 0.004, 0.010}, current_lag},
    {"current_limit", "current_A", true, true, {0.75, 0.55, 0.35}, current_limit},
    {"torque_constant", "gain", true, true, {0.08, 0.15, 0.3}, torque_constant},
    {"rotor_inertia", "inertia_kg_m2", true, false, {1.5, 2.2, 3.5}, rotor_inertia},
    {"gear_stiffness", "stiffness_Nm_rad", true, true, {60.0, 35.0, 20.0}, gear_stiffness},
    {"gear_friction", "coulomb_Nm", true, false, {0.02, 0.05, 0.10}, gear_friction},
    {"cogging", "amplitude_Nm", true, true, {0.01, 0.03, 0.06}, cogging},
    {"backlash", "play_rad", true, true, {0.002, 0.005, 0.012}, backlash},
    {"load_friction", "coulomb_Nm", true, true, {0.02, 0.05, 0.10}, load_friction},
    {"load_mass", "inertia_kg_m2", true, true, {1.25, 1.6, 2.5}, load_mass},
    {"load_damping", "damping_Nms_rad", true, true, {1.3, 1.8, 3.0}, load_damping},
    {"load_stiffness", "stiffness_Nm_rad", true, true, {1.2, 1.5, 2.2}, load_stiffness},
    {"spring_hardening", "cubic_Nm_rad3", true, true, {0.15, 0.4, 1.0}, spring_hardening},
    {"external_force", "torque_Nm", true, true, {0.02, 0.05, 0.12}, external_force},
    {"gravity", "moment_Nm", true, true, {0.03, 0.08, 0.2}, gravity},
    {"force_sensor_lag", "time_constant_s", true, false, {0.0015, 0.004, 0.010}, force_sensor_lag},
    {"force_sensor_gain", "gain", true, false, {0.08, 0.15, 0.3}, force_sensor_gain},
    {"force_sensor_offset", "offset_Nm", true, false, {0.02, 0.05, 0.12}, force_sensor_offset},
    {"velocity_filter_lag", "time_constant_s", true, true, {0.002, 0.005, 0.012}, velocity_filter_lag},
};

constexpr Entry kOutside[] = {
    {"position_dependent_friction", "coulomb_Nm", true, true, {0.04, 0.08, 0.15}, position_dependent_friction},
    {"torque_fade", "loss", true, true, {0.15, 0.25, 0.4}, torque_fade},
    {"flexible_load", "share_of_inertia", true, true, {0.15, 0.3, 0.6}, flexible_load},
    {"periodic_load_force", "amplitude_Nm", true, true, {0.03, 0.08, 0.16}, periodic_load_force},
    {"random_disturbance_force", "standard_deviation_Nm", true, true, {0.02, 0.05, 0.10}, random_disturbance_force},
    {"command_dropouts", "share", true, true, {0.05, 0.12, 0.25}, command_dropouts},
};

}  // namespace

const Entry* find_entry(const std::string& name) {
  for (const Entry& entry : kKnown) {
    if (entry.name == name) return &entry;
  }
  for (const Entry& entry : kOutside) {
    if (entry.name == name) return &entry;
  }
  return nullptr;
}

std::vector<std::string> names_of(bool outside, bool rigid) {
  std::vector<std::string> names;
  const auto add = [&](const Entry& entry) {
    if (rigid ? entry.of_rigid : entry.of_spring) names.emplace_back(entry.name);
  };
  if (outside) {
    for (const Entry& entry : kOutside) add(entry);
  } else {
    for (const Entry& entry : kKnown) add(entry);
  }
  return names;
}

}  // namespace farrier::truth::electric
