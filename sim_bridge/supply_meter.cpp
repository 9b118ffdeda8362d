#include "sim_bridge/supply_meter.hpp"

#include "sim_bridge/simulated_robot.hpp"

namespace farrier::sim_bridge {

SupplyMeter::SupplyMeter(const plant::Supply& supply, double period_s) noexcept
    : period_s_(period_s), last_(supply.account()) {
  state_.tick = 0;
  state_.pressure_Pa = supply.pressure_Pa();
  state_.pump_flow_m3_s = supply.params().pump_flow_m3_s;
}

void SupplyMeter::sample(const plant::Supply& supply, Tick tick) noexcept {
  const plant::SupplyAccount& now = supply.account();
  const double since_s = static_cast<double>(tick - state_.tick) * period_s_;
  state_ = {.supply = 0,
            .tick = tick,
            .pressure_Pa = supply.pressure_Pa(),
            .flow_m3_s = (now.actuators_m3 - last_.actuators_m3) / since_s,
            .pump_flow_m3_s = (now.pump_m3 - last_.pump_m3) / since_s,
            .relief_flow_m3_s = (now.relief_m3 - last_.relief_m3) / since_s,
            .leakage_flow_m3_s = (now.leakage_m3 - last_.leakage_m3) / since_s,
            .power_W = (now.pump_J - last_.pump_J) / since_s,
            .pump_J = now.pump_J,
            .actuators_J = now.actuators_J,
            .relief_J = now.relief_J,
            .leakage_J = now.leakage_J};
  last_ = now;
}

Result<Done> check_supply(const robot::Robot& known, const robot::Robot& simulated) {
  if (known.supply && !simulated.supply) {
    return Error{simulated.path + ": has no pump, but " + known.path +
                 " has one: give supply.pump in both, or in neither"};
  }
  return Done{};
}

}  // namespace farrier::sim_bridge
