#pragma once

#include <functional>
#include <string>

namespace farrier::cli {

/// Runs work on a thread beside, with a bar of the share of it, 0 to 1, that it tells. Nothing can stop such work but
/// the end of the process: an interrupt ends it here, before `command` has written anything.
void with_bar(const std::string& command,
              const std::function<void(const std::function<void(double)>& progress)>& work);

}  // namespace farrier::cli
