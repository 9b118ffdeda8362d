#pragma once

#include <string>
#include <vector>

namespace farrier::cli {

/// A command line in which verbs and options that have new names are replaced by these; says on standard error what to
/// write from now on. Old names work for one release.
std::vector<std::string> with_new_names(std::vector<std::string> arguments);

}  // namespace farrier::cli
