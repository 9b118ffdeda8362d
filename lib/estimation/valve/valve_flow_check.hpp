#pragma once

#include "core/result.hpp"
#include "estimation/valve_flow_params.hpp"

namespace farrier::estimation {

/// Refuses settings out of range with a sentence that names all of them.
Result<Done> validate(const ValveFlowParams& params);

}  // namespace farrier::estimation
