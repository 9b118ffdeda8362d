#pragma once

// Result of `farrier compare friction`: controllers on robots whose contacts stick and whose sensors filter.

#include <span>
#include <string>
#include <vector>

#include "report/compare/vary_result.hpp"
#include "report/figures/figures.hpp"

namespace farrier::report {

/// One run: a robot under one controller, with one model of friction and one set of filters.
struct FrictionRun {
  std::string robot;
  Contender contender = Contender::kStance;
  std::string friction, filters;
  std::string refusal;        ///< why no run was made; empty: there was one
  double swing_nrmse = 0.0;   ///< of the worst joint; of the worse light quarter for the load cycle
  double stance_nrmse = 0.0;  ///< of the worst joint; of the worse heavy quarter for the load cycle
  bool left_tracking = false;
  bool announced = false;  ///< a warning or an error was on the bus

  bool refused() const noexcept { return !refusal.empty(); }
  /// The joint was no torque source: it left tracking, or an NRMSE is above 1 or not a number.
  bool diverged() const noexcept {
    return !refused() && (left_tracking || !(stance_nrmse <= 1.0) || !(swing_nrmse <= 1.0));
  }
};

/// Adds compare.friction.*.
void add_friction(Figures& figures, std::span<const FrictionRun> runs);

/// For people: a table for every robot and set of filters, a line per controller, a column per model of friction; then
/// the refusals, each once. The runs stand in the order of the tables.
std::string friction_text(std::span<const FrictionRun> runs);

}  // namespace farrier::report
