#pragma once

#include <string>

#include "core/result.hpp"

namespace farrier {

/// Where a file of this path is while it is written: the same name with ".part" behind it.
std::string part_path(const std::string& path);

/// Gives the file at part_path(path) its name, in place of the file that has it. Refuses with the reason, when the disk
/// does, and then leaves both files as they were.
Result<Done> name_part(const std::string& path);

/// Writes text to a file that is either as it was or complete, whenever the program ends. Refuses with the reason, when
/// the disk does, and then leaves the file as it was.
Result<Done> replace_file(const std::string& path, const std::string& text);

}  // namespace farrier
