#pragma once

#include <string>
#include <vector>

#include "cli/base/command_text.hpp"

namespace farrier::cli {

// Scripts by which each shell completes farrier's commands, options and their values. None of them runs farrier.

std::string bash_completion(const CommandText& farrier, const std::vector<CommandText>& commands);
std::string fish_completion(const CommandText& farrier, const std::vector<CommandText>& commands);
std::string zsh_completion(const CommandText& farrier, const std::vector<CommandText>& commands);

/// Puts a text in single quotes, as all three shells take it.
std::string quoted(const std::string& text);

}  // namespace farrier::cli
