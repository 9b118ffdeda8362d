#pragma once

#include <string>

#include "core/result.hpp"

namespace farrier::cli {

/// Refuses a path that cannot be written, before the work whose result is to go there, and removes the file an
/// earlier run left, which must not pass for this run's. Devices and pipes are left alone.
Result<Done> make_way(const std::string& path);

}  // namespace farrier::cli
