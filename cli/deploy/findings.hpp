#pragma once

#include <string>

#include "tools/deploy/finding.hpp"

namespace farrier::cli {

/// Prints what was found, each with its fix, and how many faults that makes; `subject` is what was looked at. Returns
/// the exit status: failed when there is a fault.
int print_findings(const deploy::Findings& findings, const std::string& subject);

}  // namespace farrier::cli
