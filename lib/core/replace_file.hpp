#pragma once

#include <string>

#include "core/result.hpp"

namespace farrier {

/// Writes text to a file that is either as it was or complete, whenever the program ends. Refuses with the reason, when
/// the disk does, and then leaves the file as it was.
Result<Done> replace_file(const std::string& path, const std::string& text);

}  // namespace farrier
