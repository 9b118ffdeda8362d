#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/base/command_text.hpp"

namespace farrier::cli {

/// Manual pages in roff: "farrier.1" and "farrier-<command>.1" of each, by file name. `version` stands in their footers.
std::map<std::string, std::string> man_pages(const CommandText& farrier, const std::vector<CommandText>& commands,
                                             const std::string& version);

}  // namespace farrier::cli
