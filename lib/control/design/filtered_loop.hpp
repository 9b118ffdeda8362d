#pragma once

#include "control/design/margins.hpp"

namespace farrier::control {

/// True if the loop of `gains` on `model` is stable with every measurement passing through its filter. The valve
/// current is `delay_ticks` late. A radius within 1e-6 of one counts as unstable.
bool filtered_loop_is_stable(const DiscreteModel& model, const Gains& gains, int delay_ticks,
                             const MeasurementFilters& filters) noexcept;

}  // namespace farrier::control
