#pragma once

#include <string>

#include "plant/terms/terms.hpp"

namespace farrier::report {

/// Markdown table of every effect with its parameters, for docs/effects.md.
std::string effects_table_markdown();

}  // namespace farrier::report
