#include "tools/web/supply_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "core/units.hpp"
#include "tools/web/rounded_json.hpp"
#include "world/energy_audit.hpp"

namespace farrier::web {
namespace supply_json_parts {
namespace {

using nlohmann::json;

json bar(double pressure_Pa) { return rounded(pressure_Pa / kPascalPerBar, 0.1); }
json litres_per_minute(double flow_m3_s) { return rounded(kLitrePerMinute * flow_m3_s, 0.01); }

/// In whole bars: a chart has fewer lines of pixels.
json list_of_bar(std::span<const double> pressures_Pa) {
  json list = json::array();
  for (const double pressure_Pa : pressures_Pa) {
    list.push_back(std::isfinite(pressure_Pa) ? json(std::lround(pressure_Pa / kPascalPerBar)) : json(nullptr));
  }
  return list;
}

json account_of(const std::optional<signals::SupplyTruth>& truth) {
  if (!truth) {
    return nullptr;
  }
  const world::EnergyAudit audit = world::audit_in(*truth);
  json account = json::array();
  for (const world::EnergyTerm& term : world::kEnergyTerms) {
    account.push_back(rounded(audit.*term.energy_J, 0.1));
  }
  return account;
}

}  // namespace
}  // namespace supply_json_parts

nlohmann::json supply_facts(const robot::Robot& robot) {
  using namespace supply_json_parts;
  if (!robot.supply) {
    return nullptr;
  }
  json terms = json::array();
  for (const world::EnergyTerm& term : world::kEnergyTerms) {
    terms.push_back(term.sentence);
  }
  return {{"relief", bar(robot.supply->relief_pressure_Pa)},
          {"low", robot.supply_guard ? bar(robot.supply_guard->low_Pa) : json(nullptr)},
          {"terms", std::move(terms)}};
}

nlohmann::json supply_json(const std::optional<monitor::SupplyFrame>& supply, std::size_t joints) {
  using namespace supply_json_parts;
  if (!supply) {
    return nullptr;
  }
  json states = json::array(), chambers = json::array();
  for (const signals::SupplyState& state : supply->states) {
    states.push_back({state.tick, bar(state.pressure_Pa), litres_per_minute(state.pump_flow_m3_s),
                      litres_per_minute(state.flow_m3_s)});
  }
  for (const signals::SupplyTruth& truth : supply->truths) {
    const std::size_t count = std::min(joints, truth.pressure_a_Pa.size());
    chambers.push_back({truth.tick, list_of_bar(std::span(truth.pressure_a_Pa).first(count)),
                        list_of_bar(std::span(truth.pressure_b_Pa).first(count))});
  }
  const signals::SupplyState& newest = supply->newest;
  return {{"s", std::move(states)},
          {"chambers", std::move(chambers)},
          {"pressure", bar(newest.pressure_Pa)},
          {"pump", litres_per_minute(newest.pump_flow_m3_s)},
          {"drawn", litres_per_minute(newest.flow_m3_s)},
          {"relief", litres_per_minute(newest.relief_flow_m3_s)},
          {"leakage", litres_per_minute(newest.leakage_flow_m3_s)},
          {"power", rounded(newest.power_W, 1.0)},
          {"energy", account_of(supply->newest_truth)}};
}

}  // namespace farrier::web
