#include "plant/effects/effects.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::plant {
namespace {

double full_open(const ActuatorParams& actuator) noexcept { return actuator.valve_gain * actuator.valve_current_max_A; }

Lines make_lines(const ActuatorParams& actuator) noexcept {
  return {actuator.line, actuator.bulk_modulus_Pa, actuator.supply_pressure_Pa,
          full_open(actuator) * std::sqrt(actuator.supply_pressure_Pa),
          full_open(actuator) / std::sqrt(actuator.laminar_pressure_Pa)};
}

}  // namespace

Effects::Effects(const ActuatorParams& actuator, const LoadParams& load) noexcept
    : terms_(Spool(actuator.spool, actuator.valve_current_max_A), Deadband(actuator.valve_deadband_A),
             make_lines(actuator),
             Friction(load.friction, actuator.supply_pressure_Pa * std::max(actuator.area_a, actuator.area_b),
                      velocity_scale(actuator))) {}

Effects::X Effects::set_load(const LoadParams& load, const X& x) noexcept {
  X carried = x;
  auto& friction = std::get<Friction>(terms_);
  friction.set(load.friction);
  carried[at<Friction>()] = friction.carried_over({x[at<Friction>()]})[0];
  return carried;
}

bool Effects::active() const noexcept {
  return std::apply([](const auto&... term) noexcept { return (term.active() || ...); }, terms_);
}

double Effects::fastest_rate(double mass) const noexcept {
  double fastest = 0.0;
  for_each([&]<std::size_t>(const auto& term) noexcept {
    if (term.active()) {
      fastest = std::max(fastest, term.fastest_rate(mass));
    }
  });
  return fastest;
}

Effects::X Effects::scale() const noexcept {
  X all{};
  for_each([&]<std::size_t At>(const auto& term) noexcept { place<At>(term.scale(), all); });
  return all;
}

Effects::X Effects::rest(const RestPoint& point) const noexcept {
  X all{};
  for_each([&]<std::size_t At>(const auto& term) noexcept { place<At>(term.rest(point), all); });
  return all;
}

}  // namespace farrier::plant
