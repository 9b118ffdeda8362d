#pragma once

// The update logics of Hubacher (2014), Section 5.3.1, beside each other.

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "report/figures/figures.hpp"
#include "report/trot/tracking.hpp"

namespace farrier::report {

/// Work of an update logic in a run.
struct LogicWork {
  std::uint64_t looks = 0;     ///< estimates looked at
  std::uint64_t designs = 0;   ///< controllers designed for them
  std::uint64_t accepted = 0;  ///< gains issued
  double look_us = 0.0;        ///< mean time of a look, designs included
};

/// One logic on the load cycle of a rig and on a trot.
struct UpdateLogicResult {
  std::string method;                     ///< as in a robot file
  std::array<double, 4> quarter_nrmse{};  ///< quarter_error()
  LogicWork rig{};
  Tracking tracking{};  ///< of the trot
  LogicWork trot{};
};

/// Beyond it a joint's stance NRMSE, or a quarter's, counts as diverged.
inline constexpr double kDivergedAbove = 1.0;

/// Adds trot.update_logic.*. The one of distinct_poles, the default, must not diverge.
void add_update_logic(Figures& figures, std::span<const UpdateLogicResult> results);

/// The same as a table for people, a line per logic.
std::string update_logic_table(std::span<const UpdateLogicResult> results);

}  // namespace farrier::report
