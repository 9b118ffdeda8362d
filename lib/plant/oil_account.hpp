#pragma once

#include "plant/actuator_equations.hpp"

namespace farrier::plant {

/// Oil and energy of an actuator over a time, m^3 and J; or at one instant, per second. The supply's energy is that of
/// return, valve, leakage, friction and work, and what the oil stores.
struct OilAccount {
  double supply_m3 = 0.0;   ///< drawn
  double supply_J = 0.0;    ///< with it
  double return_J = 0.0;    ///< given to the return line
  double valve_J = 0.0;     ///< lost in the valve's open ports
  double leakage_J = 0.0;   ///< lost past the lands, past the piston and in lines
  double friction_J = 0.0;  ///< lost by damping and seals of the piston, and taken by its end stops
  double work_J = 0.0;      ///< done by the actuator

  /// Adds a share of another.
  void add(const OilAccount& other, double share) noexcept {
    supply_m3 += share * other.supply_m3;
    supply_J += share * other.supply_J;
    return_J += share * other.return_J;
    valve_J += share * other.valve_J;
    leakage_J += share * other.leakage_J;
    friction_J += share * other.friction_J;
    work_J += share * other.work_J;
  }
};

/// Oil at one instant, on its way from the valve to the piston.
struct OilPath {
  OpenValve valve;
  bool extends;            ///< the valve connects chamber a to the supply
  ChamberFeed feed;        ///< inflow of the chambers: the valve's and what passes it
  double past_lands_m3_s;  ///< past the valve's closed lands from the supply
  double supply_Pa, return_Pa;
  double behind_a_Pa, behind_b_Pa;  ///< pressures behind the valve
  double chamber_a_Pa, chamber_b_Pa;
};

/// The account per second, for the force of the oil and the force on the mechanism, which moves at `velocity`.
inline OilAccount rates_of(const OilPath& path, double hydraulic_force, double mechanism_force,
                           double velocity) noexcept {
  const double valve_a = path.feed.flow_a / path.feed.root_a;
  const double valve_b = path.feed.flow_b / path.feed.root_b;
  const double into_a = valve_a + path.feed.past_a;
  const double into_b = valve_b + path.feed.past_b;
  const double drawn = (path.extends ? valve_a : valve_b) + path.past_lands_m3_s;
  OilAccount rates{.supply_m3 = drawn,
                   .supply_J = drawn * path.supply_Pa,
                   .return_J = (drawn - into_a - into_b) * path.return_Pa,
                   .valve_J = valve_a * (path.valve.port_a_Pa - path.behind_a_Pa) +
                              valve_b * (path.valve.port_b_Pa - path.behind_b_Pa),
                   .friction_J = (hydraulic_force - mechanism_force) * velocity,
                   .work_J = mechanism_force * velocity};
  rates.leakage_J =
      rates.supply_J - rates.return_J - rates.valve_J - into_a * path.chamber_a_Pa - into_b * path.chamber_b_Pa;
  return rates;
}

/// Adds what the oil of equations exchanges while their state is integrated: the mean of begin and end of each substep.
template <class Equations, class State>
class OilMeter {
 public:
  /// All outlive this.
  OilMeter(const Equations& equations, const typename Equations::Input& input, const State& begin,
           OilAccount& account) noexcept
      : equations_(equations), input_(input), account_(account), begin_(equations.rates_of_oil(begin, input)) {}

  void book(const State& end, double time_s) noexcept {
    const OilAccount rates = equations_.rates_of_oil(end, input_);
    account_.add(begin_, 0.5 * time_s);
    account_.add(rates, 0.5 * time_s);
    begin_ = rates;
  }

 private:
  const Equations& equations_;
  const typename Equations::Input& input_;
  OilAccount& account_;
  OilAccount begin_;
};

}  // namespace farrier::plant
