#include "trials/truth/machine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trials/truth/contact.hpp"
#include "trials/truth/wave.hpp"

namespace farrier::truth {
namespace {

constexpr double kAtmosphere_Pa = 1e5;
constexpr double kPolytropic = 1.4;
/// Lands' edges are round by this part of the largest current: what an ideal valve leaks at null.
constexpr double kEdge = 2e-4;
/// Oil between a resisting supply and the valve evens its pressure out in this time: short against a sample, and no
/// algebraic loop.
constexpr double kSupplyTime_s = 1e-4;

struct Openings {
  double extend, retract;  ///< A: of P->A and B->T, of P->B and A->T
};

struct Flows {
  double a, b, supply;  ///< m^3/s: into each chamber, out of the supply
};

// (w + sqrt(w^2 + e^2)) / 2: w where the land is open, 0 where it is shut, an edge of e between.
double rounded(double opening, double edge) { return 0.5 * (opening + std::sqrt(opening * opening + edge * edge)); }

Openings lands(const Machine& m, double time_s, double spool_A) {
  const double s = std::clamp(spool_A, -m.current_max_A, m.current_max_A);
  const double edge = kEdge * m.current_max_A;
  const double wear = 1.0 - m.gain_loss_per_s * std::max(time_s, 0.0);
  return {wear * (1.0 + m.asymmetry) * rounded(s - m.overlap_A, edge),
          wear * (1.0 - m.asymmetry) * rounded(-s - m.overlap_A, edge)};
}

double slope(double drop, double laminar) {
  const double size = std::abs(drop);
  if (size >= laminar) {
    return 0.5 / std::sqrt(size);
  }
  const double r = drop / laminar;
  return (1.25 - 0.75 * r * r) / std::sqrt(laminar);
}

// Pressure between the lands of a port and its bore, by Newton, with bisection if it leaves the bracket. The flow
// through the lands equals the flow through the bore:
//   o_p f(P - p_n) - o_t f(p_n - T) = u_s f(p_n - p),  falling in p_n
double port_node(const Machine& m, double open_supply, double open_return, double supply, double chamber) {
  const double us = m.port_current_A, d = m.laminar_Pa;
  double low = std::min({supply, m.return_Pa, chamber}), high = std::max({supply, m.return_Pa, chamber});
  const bool filling = open_supply > open_return;
  const double r = (filling ? open_supply : open_return) / us;
  double p = (chamber + r * r * (filling ? supply : m.return_Pa)) / (1.0 + r * r);
  for (int i = 0; i < 40; ++i) {
    const double excess =
        open_supply * orifice(supply - p, d) - open_return * orifice(p - m.return_Pa, d) - us * orifice(p - chamber, d);
    (excess > 0.0 ? low : high) = p;
    const double fall =
        open_supply * slope(supply - p, d) + open_return * slope(p - m.return_Pa, d) + us * slope(p - chamber, d);
    double next = p + excess / fall;
    if (!(next >= low && next <= high)) {
      next = 0.5 * (low + high);
    }
    if (std::abs(next - p) < 1.0) {
      return next;
    }
    p = next;
  }
  return p;
}

Flows valve(const Machine& m, const Openings& o, double supply, double pa, double pb) {
  if (m.port_current_A > 0.0) {
    pa = port_node(m, o.extend, o.retract, supply, pa);
    pb = port_node(m, o.retract, o.extend, supply, pb);
  }
  const double d = m.laminar_Pa, k = m.valve_gain;
  const double supply_a = k * o.extend * orifice(supply - pa, d), supply_b = k * o.retract * orifice(supply - pb, d);
  return {supply_a - k * o.retract * orifice(pa - m.return_Pa, d),
          supply_b - k * o.extend * orifice(pb - m.return_Pa, d), supply_a + supply_b};
}

// Bulk modulus of oil and air together, per volume at 1 bar:
//   V(p) = (1 - r) (1 - (p - p0) / beta) + r (p0 / p)^(1/n),   1 / beta_e = -V'(p) / V(p)
double stiffness_of_mixture(const Machine& m, double pressure_Pa) {
  if (m.air_fraction <= 0.0) {
    return m.bulk_modulus_Pa;
  }
  const double p = std::max(pressure_Pa, kAtmosphere_Pa), r = m.air_fraction;
  const double air = r * std::pow(kAtmosphere_Pa / p, 1.0 / kPolytropic);
  const double volume = (1.0 - r) * (1.0 - (p - kAtmosphere_Pa) / m.bulk_modulus_Pa) + air;
  return volume / ((1.0 - r) / m.bulk_modulus_Pa + air / (kPolytropic * p));
}

// A stop pushes and never pulls; its damper engages with depth, so that force is continuous at first touch.
double push(double depth, double approach, double stiffness, double damping, double engage) {
  return depth <= 0.0 ? 0.0 : std::max(0.0, stiffness * depth + damping * std::min(1.0, depth / engage) * approach);
}

double end_stops(const Machine& m, double x, double v) {
  const double low = m.stop_inset, high = m.stroke - m.stop_inset, engage = 1e-3 * m.stroke;
  return push(low - x, -v, m.stop_stiffness, m.stop_damping, engage) -
         push(x - high, v, m.stop_stiffness, m.stop_damping, engage);
}

// Across the play: force of the piston on the load.
double across_play(const Machine& m, const Vector& x) {
  const double lead = x[kPistonX] - x[kX], rate = x[kPistonV] - x[kV], half = 0.5 * m.play, engage = 0.02 * m.play;
  const double damping = contact_damping(m);
  return push(lead - half, rate, m.stop_stiffness, damping, engage) -
         push(-lead - half, -rate, m.stop_stiffness, damping, engage);
}

// Supply at the valve: ideal, behind a resistance, or an accumulator fed through a line.
double feed(const Machine& m, double time_s, double drawn, const Vector& x, Vector& dx) {
  const double pump = m.supply_Pa + wave(m.ripple_Pa, m.ripple_rad_s * time_s);
  dx[kSupply] = dx[kFeed] = 0.0;
  if (m.accumulator_Pa_m3 > 0.0) {
    dx[kSupply] = m.accumulator_Pa_m3 * (x[kFeed] - drawn);
    dx[kFeed] = (pump - x[kSupply] - m.feed_resistance * x[kFeed]) / m.feed_inertance;
  } else if (m.supply_resistance > 0.0) {
    dx[kSupply] = (pump - m.supply_resistance * drawn - x[kSupply]) / kSupplyTime_s;
  }
  return pump;
}

}  // namespace

double rub(const Contact& c, double off_middle, double v, double z, double& dz) {
  if (c.coulomb <= 0.0) {
    dz = 0.0;
    return 0.0;
  }
  const double ratio = v / c.stribeck_velocity, stribeck = std::exp(-ratio * ratio);
  double level = c.coulomb + (c.breakaway - c.coulomb) * stribeck;
  if (c.waviness > 0.0) {
    level *= 1.0 + c.waviness * std::sin(2.0 * std::numbers::pi * off_middle / c.wavelength);
  }
  const double stiffness = c.breakaway / c.presliding;
  dz = v - stiffness * std::abs(v) * z / level;
  return stiffness * z + c.bristle_damping * stribeck * dz;
}

double contact_damping(const Machine& m) { return 0.6 * std::sqrt(m.stop_stiffness * m.load_mass); }

double orifice(double drop_Pa, double laminar_Pa) {
  const double size = std::abs(drop_Pa);
  if (size >= laminar_Pa) {
    return std::copysign(std::sqrt(size), drop_Pa);
  }
  const double r = drop_Pa / laminar_Pa;
  return std::sqrt(laminar_Pa) * r * (1.25 - 0.25 * r * r);
}

Outcome differentiate(const Machine& m, double time_s, const Vector& x, const Acting& acting, Vector& dx) {
  const bool rigid = m.play <= 0.0;
  const double middle = 0.5 * m.stroke;
  const double position = x[kX], v = x[kV];
  const double piston_x = rigid ? position : x[kPistonX], piston_v = rigid ? v : x[kPistonV];

  double spool = acting.command_A;
  dx[kSpool] = dx[kSpoolRate] = 0.0;
  if (m.spool_rad_s > 0.0) {
    spool = x[kSpool];
    dx[kSpool] = x[kSpoolRate];
    dx[kSpoolRate] =
        m.spool_rad_s * (m.spool_rad_s * (acting.command_A - spool) - 2.0 * m.spool_damping * x[kSpoolRate]);
  }

  // p' = beta / V (q - V')
  const double pa = std::max(x[kPa], 0.0), pb = std::max(x[kPb], 0.0);
  const bool held_supply = m.accumulator_Pa_m3 > 0.0 || m.supply_resistance > 0.0;
  const double supply = held_supply ? x[kSupply] : m.supply_Pa + wave(m.ripple_Pa, m.ripple_rad_s * time_s);
  const Flows q = valve(m, lands(m, time_s, spool), supply, pa, pb);
  const double drawn = std::max(q.supply, 0.0), leak = m.leakage_m3_s_Pa * (pa - pb);
  feed(m, time_s, drawn, x, dx);
  const double volume_a = m.line_volume_m3 + m.area_a * piston_x;
  const double volume_b = m.line_volume_m3 + m.area_b * (m.stroke - piston_x);
  dx[kPa] = stiffness_of_mixture(m, pa) / volume_a * (q.a - leak - m.area_a * piston_v);
  dx[kPb] = stiffness_of_mixture(m, pb) / volume_b * (q.b + leak + m.area_b * piston_v);
  if (x[kPa] <= 0.0) dx[kPa] = std::max(dx[kPa], 0.0);
  if (x[kPb] <= 0.0) dx[kPb] = std::max(dx[kPb], 0.0);

  // Forces on the piston, and the resistance of the load.
  const double on_piston = m.area_a * pa - m.area_b * pb + end_stops(m, piston_x, piston_v) -
                           m.piston_damping * piston_v -
                           rub(m.piston_contact, piston_x - middle, piston_v, x[kPistonBristle], dx[kPistonBristle]);
  const double stretch = position - m.spring_rest;
  double on_load = m.external_force + acting.random_force + wave(m.beat_force, m.beat_rad_s * time_s) -
                   m.load_damping * v - (m.load_stiffness + m.cubic_stiffness * stretch * stretch) * stretch -
                   rub(m.load_contact, position - middle, v, x[kLoadBristle], dx[kLoadBristle]);
  double near_mass = m.load_mass;
  dx[kBranchX] = dx[kBranchV] = 0.0;
  if (m.branch_share > 0.0) {
    const double w = m.branch_rad_s, mass = m.branch_share * m.load_mass;
    dx[kBranchX] = x[kBranchV];
    dx[kBranchV] = w * w * (position - x[kBranchX]) + 2.0 * m.branch_damping * w * (v - x[kBranchV]);
    near_mass -= mass;
    on_load -= mass * dx[kBranchV];
  }

  double cell = 0.0;
  dx[kX] = v;
  dx[kPistonX] = piston_v;
  if (rigid) {
    dx[kV] = dx[kPistonV] = (on_piston + on_load) / (m.piston_mass + near_mass);
    cell = on_piston - m.piston_mass * dx[kV];
  } else {
    cell = across_play(m, x);
    dx[kPistonV] = (on_piston - cell) / m.piston_mass;
    dx[kV] = (cell + on_load) / near_mass;
  }

  const double felt = m.force_gain * (1.0 + m.crosstalk * (position - middle)) * cell;
  dx[kForceLag] = m.force_lag_s > 0.0 ? (felt - x[kForceLag]) / m.force_lag_s : 0.0;
  dx[kVelocityLag] = m.velocity_lag_s > 0.0 ? (v - x[kVelocityLag]) / m.velocity_lag_s : 0.0;
  return {felt, drawn, supply};
}

void advance(const Machine& machine, double time_s, double h, const Acting& acting, Vector& x) {
  Vector k1, k2, k3, k4, at;
  differentiate(machine, time_s, x, acting, k1);
  for (std::size_t i = 0; i < kPlaces; ++i) at[i] = x[i] + 0.5 * h * k1[i];
  differentiate(machine, time_s + 0.5 * h, at, acting, k2);
  for (std::size_t i = 0; i < kPlaces; ++i) at[i] = x[i] + 0.5 * h * k2[i];
  differentiate(machine, time_s + 0.5 * h, at, acting, k3);
  for (std::size_t i = 0; i < kPlaces; ++i) at[i] = x[i] + h * k3[i];
  differentiate(machine, time_s + h, at, acting, k4);
  for (std::size_t i = 0; i < kPlaces; ++i) x[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
  x[kPa] = std::max(x[kPa], 0.0);
  x[kPb] = std::max(x[kPb], 0.0);
}

Vector at_rest(const Machine& m) {
  Vector x{};
  x[kX] = x[kPistonX] = x[kBranchX] = 0.5 * m.stroke;
  x[kPa] = m.supply_Pa * m.area_b / (m.area_a + m.area_b);
  x[kPb] = m.supply_Pa * m.area_a / (m.area_a + m.area_b);
  x[kSupply] = m.supply_Pa;
  return x;
}

}  // namespace farrier::truth
