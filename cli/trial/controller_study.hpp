#pragma once

#include "cli/trial/trial_study.hpp"

namespace farrier::cli {

/// `farrier trial hide --controllers`: the same hidden joint under every kind of controller. Each robot trots in this
/// process and is recorded, and the recording of the hidden joint is diagnosed. Prints the names and sizes, and the
/// figures hide.controllers.*. Exit status of the command.
int run_controller_study(const robot::Robot& nominal, const TrialOptions& options);

}  // namespace farrier::cli
