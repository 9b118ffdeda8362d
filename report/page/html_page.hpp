#pragma once

#include <string>

#include "core/result.hpp"
#include "report/figures/outcome.hpp"

namespace farrier::report {

/// How every report begins: head with style, title, verdict, and why it fails where it does.
std::string page_head(const std::string& title, const Outcome& outcome);

/// How every report ends: figures, processes, run, configuration.
std::string page_foot(const Outcome& outcome);

/// Writes out_dir/index.html, as replace_file does, and returns its path; refuses what the disk does not take.
Result<std::string> write_page(const std::string& out_dir, const std::string& page);

}  // namespace farrier::report
