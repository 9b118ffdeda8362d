#pragma once

#include "core/result.hpp"

namespace farrier::plant {

/// Hydraulic supply of a whole robot: a pump of constant flow, a relief valve, an accumulator, and the oil that every
/// valve passes to the return line while it is shut. All finite.
struct SupplyParams {
  double relief_pressure_Pa = 0.0;     ///< the pump's flow beyond this is spilled; > return pressure
  double return_pressure_Pa = 0.0;     ///< of the reservoir, p_t; >= 0
  double pump_flow_m3_s = 0.0;         ///< >= 0
  double accumulator_volume_m3 = 0.0;  ///< of the gas at its precharge; >= 0, 0: no accumulator
  double precharge_Pa = 0.0;           ///< pressure of the gas while no oil is in; > 0 with an accumulator
  double polytropic_exponent = 1.3;    ///< n of the gas, p V^n; > 1
  double compliance_m3_Pa = 0.0;       ///< of manifold and hoses; > 0
  double null_leakage_m3_s_Pa = 0.0;   ///< of all valves together; >= 0
};

/// Refuses values no supply has, naming each.
Result<Done> validate(const SupplyParams& params);

/// Energy of a supply since its start, J. Pump = actuators + relief + leakage + removed + what accumulator and hoses have
/// gained.
struct SupplyAccount {
  double pump_J = 0.0;
  double actuators_J = 0.0;  ///< given to the valves
  double relief_J = 0.0;     ///< spilled
  double leakage_J = 0.0;    ///< past shut valves
  double removed_J = 0.0;    ///< that left with an accumulator's gas when its volume was set
  double pump_m3 = 0.0;
  double actuators_m3 = 0.0;
  double relief_m3 = 0.0;
  double leakage_m3 = 0.0;
};

/// The pressure follows from the oil that accumulator and hoses hold, Merritt (1967), 11-4 for the accumulator:
///   V(p) = C p + V_0 (1 - (p_0 / p)^(1/n)) for p > p_0, C p below.
class Supply {
 public:
  /// Filled up to the relief pressure. Refuses what validate() refuses.
  static Result<Supply> create(const SupplyParams& params);

  double pressure_Pa() const noexcept { return pressure_Pa_; }
  /// Flow of the actuators over the last step, m^3/s.
  double flow_m3_s() const noexcept { return flow_m3_s_; }
  const SupplyAccount& account() const noexcept { return account_; }
  /// Energy in accumulator and hoses.
  double stored_J() const noexcept;
  const SupplyParams& params() const noexcept { return params_; }

  /// Draws oil (m^3, negative gives it back) in a step of `step_s` > 0. A supply that is drawn empty stays at 0 Pa.
  void advance(double drawn_m3, double step_s) noexcept;

  /// A pump or an accumulator that changes in a run; the pressure is continuous.
  void set_pump_flow(double flow_m3_s) noexcept { params_.pump_flow_m3_s = flow_m3_s; }
  void set_accumulator_volume(double volume_m3) noexcept;

 private:
  explicit Supply(const SupplyParams& params) noexcept;
  /// Oil in accumulator and hoses at a pressure, and its rate with the pressure.
  double volume_m3(double pressure_Pa) const noexcept;
  double compliance_m3_Pa(double pressure_Pa) const noexcept;
  /// True if there is oil in the accumulator at a pressure.
  bool holds_oil(double pressure_Pa) const noexcept;
  /// (p_0 / p)^(1/n): the gas's share of its volume; 1 while no oil is in.
  double gas_share(double pressure_Pa) const noexcept;
  double pressure_at(double volume_m3) const noexcept;

  SupplyParams params_;
  double pressure_Pa_;
  double volume_m3_;
  double flow_m3_s_ = 0.0;
  SupplyAccount account_;
};

}  // namespace farrier::plant
