#include "trials/truth/hide.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace farrier::truth {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;

// Currents are relative to what the run uses: a valve too large for its joint never opens far, and an overlap of 5 % of
// its largest current would shut it.
double current_unit(const Machine& m, const Extents& e) { return std::min(m.current_max_A, 2.0 * e.peak_current_A); }

// Likewise forces: of what the actuator can push, or of what the load asks where that is far less.
double force_unit(const Extents& e) { return std::min(e.push, 6.0 * e.rms_force); }

// Multiplied or divided, by chance.
double times(double value, double factor, const Chance& chance) {
  const double f = 1.0 + (factor - 1.0) * chance.spread();
  return chance.sign() > 0.0 ? value * f : value / f;
}

// Stribeck velocity 10 mm/s and 10 um of presliding on a cylinder of 80 mm stroke: steel on rubber.
Contact dry(double coulomb, double mass, const Extents& e, const Chance& chance) {
  Contact c;
  c.coulomb = coulomb;
  c.breakaway = coulomb * chance.within(1.2, 1.6);
  c.stribeck_velocity = 0.01 * e.length;
  c.presliding = 1e-5 * e.length;
  c.bristle_damping = 0.4 * std::sqrt(c.breakaway / c.presliding * mass);
  return c;
}

double valve_deadband(Machine& m, double size, const Extents& e, const Chance& c) {
  return m.overlap_A = size * c.spread() * current_unit(m, e);
}
double valve_bias(Machine& m, double size, const Extents& e, const Chance& c) {
  return m.bias_A = size * c.spread() * c.sign() * current_unit(m, e);
}
double valve_asymmetry(Machine& m, double size, const Extents&, const Chance& c) {
  return m.asymmetry = size * c.spread() * c.sign();
}
double valve_dynamics(Machine& m, double size_Hz, const Extents&, const Chance& c) {
  m.spool_damping = c.within(0.5, 0.9);
  return m.spool_rad_s = kFullTurn * size_Hz * c.spread();
}
double flow_saturation(Machine& m, double size, const Extents& e, const Chance& c) {
  return m.port_current_A = size * c.spread() * e.peak_current_A;
}
// On the clock's grid of 50 per period, and at least 5 of those from a whole period.
double input_delay(Machine& m, double size_s, const Extents& e, const Chance& c) {
  long parts = std::lround(50.0 * size_s * c.spread() / e.period_s);
  parts += std::clamp(5L - parts % 50, 0L, 5L) - std::clamp(parts % 50 - 45L, 0L, 5L);
  return m.delay_s = static_cast<double>(parts) * e.period_s / 50.0;
}
double load_friction(Machine& m, double size, const Extents& e, const Chance& c) {
  m.load_contact = dry(size * c.spread() * force_unit(e), m.load_mass, e, c);
  return m.load_contact.coulomb;
}
double piston_friction(Machine& m, double size, const Extents& e, const Chance& c) {
  m.piston_contact = dry(size * c.spread() * e.push, m.load_mass, e, c);
  return m.piston_contact.coulomb;
}
double internal_leakage(Machine& m, double size, const Extents&, const Chance& c) {
  return m.leakage_m3_s_Pa = size * c.spread() * m.valve_gain * m.current_max_A / std::sqrt(m.supply_Pa);
}
// Relative to what oil is like: air in oil of an effective 5.5e8 Pa hides behind what is in it already.
double air_entrainment(Machine& m, double size, const Extents&, const Chance& c) {
  return m.air_fraction = size * c.spread() * std::clamp(1.8e9 / m.bulk_modulus_Pa, 1.0, 2.0);
}
double supply_droop(Machine& m, double size, const Extents& e, const Chance& c) {
  return m.supply_resistance = size * c.spread() * m.supply_Pa / e.peak_flow_m3_s;
}
double load_mass(Machine& m, double factor, const Extents&, const Chance& c) {
  return m.load_mass = times(m.load_mass, factor, c);
}
double load_stiffness(Machine& m, double factor, const Extents& e, const Chance& c) {
  if (m.load_stiffness > 0.0) {
    return m.load_stiffness = times(m.load_stiffness, factor, c);
  }
  // Factors 1.2, 1.5, 2.2 of a spring are 10, 25, 60 % of the force where there is none.
  return m.load_stiffness = 0.5 * (factor - 1.0) * c.spread() * e.rms_force / e.rms_motion;
}
double load_damping(Machine& m, double factor, const Extents&, const Chance& c) {
  return m.load_damping = times(m.load_damping, factor, c);
}
double external_force(Machine& m, double size, const Extents& e, const Chance& c) {
  return m.external_force = size * c.spread() * c.sign() * force_unit(e);
}
double force_sensor_lag(Machine& m, double size_s, const Extents&, const Chance& c) {
  return m.force_lag_s = size_s * c.spread();
}
double force_sensor_gain(Machine& m, double size, const Extents&, const Chance& c) {
  return m.force_gain = 1.0 + size * c.spread() * c.sign();
}
double force_sensor_offset(Machine& m, double size, const Extents& e, const Chance& c) {
  return m.force_offset = size * c.spread() * c.sign() * force_unit(e);
}
double spring_hardening(Machine& m, double size, const Extents& e, const Chance& c) {
  const double cube = e.stretch * e.stretch * e.stretch;
  const double linear = m.load_stiffness > 0.0 ? m.load_stiffness * e.stretch : e.rms_force;
  return m.cubic_stiffness = size * c.spread() * linear / cube;
}
double velocity_filter_lag(Machine& m, double size_s, const Extents&, const Chance& c) {
  return m.velocity_lag_s = size_s * c.spread();
}
// Without a spring nothing presses flanks together, and a third of the play is heard as much.
double backlash(Machine& m, double size_m, const Extents& e, const Chance& c) {
  return m.play = size_m * c.spread() * e.length * (m.load_stiffness > 0.0 ? 1.0 : 0.3);
}
double end_stop(Machine& m, double cut, const Extents& e, const Chance& c) {
  return m.stop_inset = 0.5 * m.stroke - e.excursion * (1.0 - cut * c.spread());
}
double valve_hysteresis(Machine& m, double size, const Extents& e, const Chance& c) {
  return m.hysteresis_A = size * c.spread() * current_unit(m, e);
}
// A share of the load behind a spring, damped to 5 %; the whole mass stays.
double flexible_load(Machine& m, double size, const Extents&, const Chance& c) {
  m.branch_rad_s = kFullTurn * c.within(8.0, 20.0);
  m.branch_damping = 0.05;
  return m.branch_share = size * c.spread();
}

// From a quarter of the level to nearly twice it and back over two thirds of the largest excursion.
double position_dependent_friction(Machine& m, double size, const Extents& e, const Chance& c) {
  m.load_contact = dry(size * c.spread() * force_unit(e), m.load_mass, e, c);
  m.load_contact.presliding *= 4.0;  // bristles under the lowest level stay as slow as elsewhere
  m.load_contact.waviness = 0.75;
  m.load_contact.wavelength = 0.67 * e.excursion;
  return m.load_contact.coulomb;
}
double pump_ripple(Machine& m, double size, const Extents&, const Chance& c) {
  m.ripple_rad_s = kFullTurn * c.within(20.0, 60.0);
  return m.ripple_Pa = size * c.spread() * m.supply_Pa;
}
double gain_drift(Machine& m, double size, const Extents& e, const Chance& c) {
  const double lost = size * c.spread();
  m.gain_loss_per_s = lost / e.duration_s;
  return lost;
}
double force_sensor_crosstalk(Machine& m, double size, const Extents& e, const Chance& c) {
  return m.crosstalk = size * c.spread() * c.sign() / e.excursion;
}
// The pressure swings by the named share of the supply when the largest flow sets in: R0 = sqrt(inertance stiffness).
double supply_accumulator(Machine& m, double size, const Extents& e, const Chance& c) {
  const double surge = size * c.spread() * m.supply_Pa / e.peak_flow_m3_s, omega = kFullTurn * c.within(4.0, 9.0);
  m.accumulator_Pa_m3 = surge * omega;
  m.feed_inertance = surge / omega;
  m.feed_resistance = 0.1 * surge;
  return surge;
}
double periodic_load_force(Machine& m, double size, const Extents& e, const Chance& c) {
  m.beat_rad_s = kFullTurn * c.within(3.0, 12.0);
  return m.beat_force = size * c.spread() * force_unit(e);
}
double random_disturbance_force(Machine& m, double size, const Extents& e, const Chance& c) {
  return m.random_force = size * c.spread() * force_unit(e);
}
double command_dropouts(Machine& m, double size, const Extents&, const Chance& c) {
  return m.dropout = size * c.spread();
}

constexpr Entry kKnown[] = {
    {"valve_deadband", "half_width_A", {0.01, 0.025, 0.05}, valve_deadband},
    {"valve_bias", "current_A", {0.005, 0.015, 0.03}, valve_bias},
    {"valve_asymmetry", "ratio", {0.08, 0.15, 0.3}, valve_asymmetry},
    {"valve_dynamics", "natural_frequency_rad_s", {120.0, 60.0, 30.0}, valve_dynamics},
    {"flow_saturation", "saturation_current_A", {1.2, 0.7, 0.4}, flow_saturation},
    {"input_delay", "delay_s", {0.0015, 0.003, 0.006}, input_delay},
    {"load_friction", "coulomb", {0.02, 0.05, 0.10}, load_friction},
    {"piston_friction", "coulomb", {0.015, 0.04, 0.08}, piston_friction},
    {"internal_leakage", "leakage_m3_s_Pa", {0.005, 0.015, 0.04}, internal_leakage},
    {"air_entrainment", "air_fraction", {0.01, 0.03, 0.08}, air_entrainment},
    {"supply_droop", "resistance_Pa_s_m3", {0.1, 0.2, 0.4}, supply_droop},
    {"load_mass", "mass", {1.25, 1.6, 2.5}, load_mass},
    {"load_stiffness", "stiffness", {1.2, 1.5, 2.2}, load_stiffness},
    {"load_damping", "damping", {1.3, 1.8, 3.0}, load_damping},
    {"external_force", "force", {0.02, 0.05, 0.12}, external_force},
    {"force_sensor_lag", "time_constant_s", {0.0015, 0.004, 0.010}, force_sensor_lag},
    {"force_sensor_gain", "gain", {0.08, 0.15, 0.3}, force_sensor_gain},
    {"force_sensor_offset", "offset", {0.02, 0.05, 0.12}, force_sensor_offset},
    {"spring_hardening", "cubic_stiffness", {0.15, 0.4, 1.0}, spring_hardening},
    {"velocity_filter_lag", "time_constant_s", {0.002, 0.005, 0.012}, velocity_filter_lag},
    {"backlash", "play", {0.15e-3, 0.4e-3, 1.0e-3}, backlash},
    {"end_stop", "inset", {0.05, 0.15, 0.30}, end_stop},
    {"valve_hysteresis", "half_width_A", {0.015, 0.035, 0.08}, valve_hysteresis},
    {"flexible_load", "share_of_mass", {0.15, 0.3, 0.6}, flexible_load},
    {"position_dependent_friction", "coulomb", {0.04, 0.08, 0.15}, position_dependent_friction},
};

constexpr Entry kOutside[] = {
    {"pump_ripple", "amplitude_Pa", {0.08, 0.16, 0.3}, pump_ripple},
    {"gain_drift", "loss", {0.15, 0.25, 0.4}, gain_drift},
    {"force_sensor_crosstalk", "gain_per_position", {0.15, 0.3, 0.6}, force_sensor_crosstalk},
    {"supply_accumulator", "surge_Pa_s_m3", {0.1, 0.2, 0.4}, supply_accumulator},
    {"periodic_load_force", "amplitude", {0.03, 0.08, 0.16}, periodic_load_force},
    {"random_disturbance_force", "standard_deviation", {0.02, 0.05, 0.10}, random_disturbance_force},
    {"command_dropouts", "share", {0.05, 0.12, 0.25}, command_dropouts},
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

std::vector<std::string> names_of(bool outside) {
  std::vector<std::string> names;
  if (outside) {
    for (const Entry& entry : kOutside) names.emplace_back(entry.name);
  } else {
    for (const Entry& entry : kKnown) names.emplace_back(entry.name);
  }
  return names;
}

}  // namespace farrier::truth
