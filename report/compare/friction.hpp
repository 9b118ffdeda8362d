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
  /// An NRMSE is above 1, which no force at all would have.
  bool is_no_torque_source() const noexcept { return is_above(1.0); }
  /// An NRMSE is above 2, the most of a stable loop that lags, or the joint left tracking.
  bool diverged() const noexcept { return is_above(2.0) || (!refused() && left_tracking); }

 private:
  bool is_above(double nrmse) const noexcept {
    return !refused() && (!(stance_nrmse <= nrmse) || !(swing_nrmse <= nrmse));
  }
};

/// Adds compare.friction.*.
void add_friction(Figures& figures, std::span<const FrictionRun> runs);

/// For people: a table for every robot and set of filters, a line per controller, a column per model of friction; then
/// the refusals, each once. The runs stand in the order of the tables.
std::string friction_text(std::span<const FrictionRun> runs);

}  // namespace farrier::report
