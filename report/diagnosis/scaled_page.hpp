#pragma once

#include <string>

#include "core/result.hpp"
#include "report/figures/outcome.hpp"
#include "report/diagnosis/scaled_result.hpp"

namespace farrier::report {

/// Writes out_dir/index.html with its pictures beside it and returns the page's path: what each effect brings, the
/// cause, the gain. Refuses when gnuplot is missing or fails, or the disk does not take the files.
Result<std::string> write_scaled_page(const std::string& out_dir, const ScaledResult& result, const Outcome& outcome);

}  // namespace farrier::report
