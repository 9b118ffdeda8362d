#pragma once

#include <string>

#include "plant/terms/terms.hpp"

namespace farrier::report {

/// Where it sits: "valve and oil", "load", "force sensor", "velocity sensor".
const char* place_of(plant::Side side) noexcept;

/// Markdown table of every effect with its parameters, for docs/effects.md.
std::string effects_table_markdown();

}  // namespace farrier::report
