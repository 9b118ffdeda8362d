#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "monitor/frame.hpp"
#include "robot/robot.hpp"

namespace farrier::web {

// Parts of the page's JSON that show the hydraulic supply. Pressures are in bar, flows in l/min, energies in J.

/// Facts of a robot's supply, which a page needs once: the pressure of its relief valve, the pressure below which it is low (null:
/// no limit), the terms of the account. Null for a robot without a pump.
nlohmann::json supply_facts(const robot::Robot& robot);

/// The supply at one frame; null for none. `joints` is their number.
nlohmann::json supply_json(const std::optional<monitor::SupplyFrame>& supply, std::size_t joints);

}  // namespace farrier::web
