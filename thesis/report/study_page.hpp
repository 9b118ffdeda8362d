#pragma once

#include <span>
#include <string>

#include "thesis/report/claims.hpp"

namespace farrier::thesis {

/// Writes out_dir/index.html: totals, the claims that fail, conditions, then each study with its conditions, pictures and claims;
/// returns its path. `outcome` holds the claims of `runs`. Refuses what the disk does not take.
Result<std::string> write_study_page(const std::string& out_dir, const report::Outcome& outcome,
                                     std::span<const StudyRun> runs);

}  // namespace farrier::thesis
