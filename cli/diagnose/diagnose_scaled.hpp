#pragma once

#include "cli/diagnose/diagnose_options.hpp"

namespace farrier::cli {

/// `farrier diagnose --units scaled`; returns the exit status.
int diagnose_scaled(const DiagnoseOptions& options);

}  // namespace farrier::cli
