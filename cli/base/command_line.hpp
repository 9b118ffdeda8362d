#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string_view>

namespace farrier::cli {

/// Every command with its options. Parsing puts what runs the command into `run`, which must live as long as the app,
/// and does nothing else.
std::unique_ptr<CLI::App> command_line(std::function<int()>& run);

bool is_command(std::string_view name);

}  // namespace farrier::cli
