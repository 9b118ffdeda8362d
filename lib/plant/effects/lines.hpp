#pragma once

#include <numbers>

#include "plant/effects/effect.hpp"
#include "plant/refusals.hpp"

namespace farrier::plant {

/// Hoses between valve and chambers, both alike. Length 0: the oil in them has no inertia, as in (2.30).
struct LineParams {
  double length_m = 0.0;             ///< L; >= 0
  double bore_m = 0.0038;            ///< D; > 0
  double density_kg_m3 = 870.0;      ///< rho of the oil; > 0
  double viscosity_Pa_s = 0.04;      ///< mu; >= 0
  double loss_coefficient = 0.0;     ///< zeta of bends and fittings together, in velocity heads; >= 0
};

inline double bore_area_m2(const LineParams& line) noexcept {
  return 0.25 * std::numbers::pi * line.bore_m * line.bore_m;
}

/// Part of a line's volume that the model puts behind the valve; the rest is the chamber's. A lumped line between a
/// shut valve and a large chamber swings at 1 / sqrt(I C) = c / (L sqrt(share)), c = sqrt(beta_e / rho). With (2 /
/// pi)^2 it swings at pi c / (2 L), as the true line does in its first mode.
inline constexpr double kValveSideShare = 4.0 / (std::numbers::pi * std::numbers::pi);

/// Volume behind the valve, m^3; the chambers' dead volume is smaller by it.
inline double valve_side_volume_m3(const LineParams& line) noexcept {
  return kValveSideShare * line.length_m * bore_area_m2(line);
}

/// `dead_volume_m3` of a chamber with its line must hold the line.
inline Result<Done> validate(const LineParams& line, double dead_volume_m3) {
  Refusals refusals("line");
  refusals.not_negative("length_m", line.length_m);
  refusals.positive("bore_m", line.bore_m);
  refusals.positive("density_kg_m3", line.density_kg_m3);
  refusals.not_negative("viscosity_Pa_s", line.viscosity_Pa_s);
  refusals.not_negative("loss_coefficient", line.loss_coefficient);
  const double volume_m3 = line.length_m * bore_area_m2(line);
  refusals.require(volume_m3 <= 1.01 * dead_volume_m3, "volume", volume_m3, "no more than line_volume_m3 by 1 %");
  return refusals.verdict();
}

/// One lumped mode per line: inertia I = rho L / A between the oil behind the valve and the chamber. The laminar loss
/// is R = 128 mu L / (pi D^4) of Hagen and Poiseuille; bends have a loss of their own, Merritt (1967), 2-3 and 3-4. The
/// equations are
///
///   I q' = p_v - p - R q - zeta rho q |q| / (2 A^2),   p_v' = beta_e / V_v (Q_valve - q).
///
/// The chamber's inflow is q; the valve works against p_v. Below 0 Pa, p_v stands for a void as a chamber's compression
/// does. States: p_va, p_vb (Pa), q_a, q_b (m^3/s).
class Lines : public Effect<4> {
 public:
  /// Tolerances use `largest_flow_m3_s` and `supply_pressure_Pa` as units. The largest flow of a laminar valve port per
  /// pressure is `full_open_gain`, K_v u_max / sqrt(delta), m^3/(s Pa).
  Lines(const LineParams& params, double bulk_modulus_Pa, double supply_pressure_Pa, double largest_flow_m3_s,
        double full_open_gain) noexcept
      : active_(params.length_m > 0.0),
        supply_pressure_Pa_(supply_pressure_Pa),
        largest_flow_m3_s_(largest_flow_m3_s),
        full_open_gain_(full_open_gain),
        volume_m3_(valve_side_volume_m3(params)),
        bulk_modulus_Pa_(bulk_modulus_Pa) {
    if (!active_) {
      return;
    }
    const double area = bore_area_m2(params);
    const double bore4 = params.bore_m * params.bore_m * params.bore_m * params.bore_m;
    inverse_inertia_ = area / (params.density_kg_m3 * params.length_m);
    resistance_ = 128.0 * params.viscosity_Pa_s * params.length_m / (std::numbers::pi * bore4);
    bend_ = 0.5 * params.loss_coefficient * params.density_kg_m3 / (area * area);
    stiffness_ = bulk_modulus_Pa / volume_m3_;
  }

  bool active() const noexcept { return active_; }
  double fastest_rate(double) const noexcept {
    const double loss = resistance_ + 2.0 * bend_ * largest_flow_m3_s_;
    return stiffness_ * full_open_gain_ + loss * inverse_inertia_ + std::sqrt(stiffness_ * inverse_inertia_);
  }
  X scale() const noexcept {
    return {supply_pressure_Pa_, supply_pressure_Pa_, largest_flow_m3_s_, largest_flow_m3_s_};
  }
  X rest(const RestPoint& at) const noexcept { return {at.pressure_a_Pa, at.pressure_b_Pa, 0.0, 0.0}; }
  void before_valve(Instant& now, const X& x) const noexcept {
    now.valve_a_Pa = x[0] > 0.0 ? x[0] : 0.0;
    now.valve_b_Pa = x[1] > 0.0 ? x[1] : 0.0;
  }
  void after_valve(Instant& now, const X& x, X& dx) const noexcept {
    dx[0] = stiffness_ * (now.feed.flow_a / now.feed.root_a - x[2]);
    dx[1] = stiffness_ * (now.feed.flow_b / now.feed.root_b - x[3]);
    dx[2] = inverse_inertia_ * (now.valve_a_Pa - now.chamber_a_Pa - (resistance_ + bend_ * std::abs(x[2])) * x[2]);
    dx[3] = inverse_inertia_ * (now.valve_b_Pa - now.chamber_b_Pa - (resistance_ + bend_ * std::abs(x[3])) * x[3]);
    now.feed = {x[2], 1.0, x[3], 1.0};
  }
  /// Space behind the valve that holds no oil, m^3.
  double void_volume_m3(double compression_Pa) const noexcept {
    return compression_Pa < 0.0 ? -compression_Pa * volume_m3_ / bulk_modulus_Pa_ : 0.0;
  }

 private:
  bool active_;
  double supply_pressure_Pa_;
  double largest_flow_m3_s_;
  double full_open_gain_;
  double volume_m3_;
  double bulk_modulus_Pa_;
  double inverse_inertia_ = 0.0;
  double resistance_ = 0.0;
  double bend_ = 0.0;
  double stiffness_ = 0.0;
};

}  // namespace farrier::plant
