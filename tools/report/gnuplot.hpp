#pragma once

#include <string>

#include "core/result.hpp"

namespace farrier::report {

/// Runs gnuplot on a script, with `directory` as its working directory; `script` is a path from there. Refuses when
/// gnuplot is not installed or does not like the script, in gnuplot's own words.
Result<Done> run_gnuplot(const std::string& directory, const std::string& script);

}  // namespace farrier::report
