#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace farrier::cli {

/// Every command of `farrier` in Markdown, as docs/cli.md has it.
std::string command_table(const CLI::App& farrier);

}  // namespace farrier::cli
