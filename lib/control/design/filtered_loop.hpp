#pragma once

#include "control/design/margins.hpp"

namespace farrier::control {

/// Whether the loop of `gains` on `model`, its valve current `delay_ticks` late, is stable when every measurement goes
/// through its filter. A radius within 1e-6 of one counts as unstable.
bool filtered_loop_is_stable(const DiscreteModel& model, const Gains& gains, int delay_ticks,
                             const MeasurementFilters& filters) noexcept;

}  // namespace farrier::control
