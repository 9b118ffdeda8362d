#pragma once

#include <string>

#include "core/keep_on.hpp"

namespace farrier::cli {

/// Stops long work at SIGINT, SIGTERM and SIGHUP, and shows its progress once it has lasted two seconds, until the last
/// copy of what is returned is gone.
KeepOn long_work(const std::string& title);

}  // namespace farrier::cli
