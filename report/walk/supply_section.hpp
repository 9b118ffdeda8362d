#pragma once

#include <string>

#include "report/page/draw_pictures.hpp"
#include "report/walk/walk_run.hpp"

namespace farrier::report {

/// HTML of the supply of a walk: its pressure and flows, where the work of its pump has gone, and the valve currents and
/// chamber pressures of each leg. Adds their pictures to `drawing`. Empty without a pump.
std::string supply_section(Drawing& drawing, const WalkRun& run);

}  // namespace farrier::report
