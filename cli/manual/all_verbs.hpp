#pragma once

#include <memory>
#include <span>

#include "cli/base/command_line.hpp"

namespace farrier::cli {

/// Every verb of every program, in the order of cli/verbs.def.
std::span<const DeclaredVerb> all_verbs() noexcept;

/// `farrier` with all of them, to read their options from.
std::unique_ptr<CLI::App> whole_command_line();

}  // namespace farrier::cli
