#pragma once

#include <string>
#include <vector>

#include "cli/base/command_text.hpp"

namespace farrier::cli {

// What each shell reads to complete farrier's commands, options and their values. None of it runs farrier.

std::string bash_completion(const CommandText& farrier, const std::vector<CommandText>& commands);
std::string fish_completion(const CommandText& farrier, const std::vector<CommandText>& commands);
std::string zsh_completion(const CommandText& farrier, const std::vector<CommandText>& commands);

/// In single quotes, as all three shells take it.
std::string quoted(const std::string& text);

}  // namespace farrier::cli
