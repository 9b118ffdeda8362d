#pragma once

#include <string>

#include "tools/playback/recorded_run.hpp"

namespace farrier::cli {

/// farrier replay --rerun estimator: prints how this version's estimates compare with the recorded ones. The command's
/// exit status: kFailed where one is different or the file is cut off, kBadInput where there is nothing to compare.
int rerun_estimator(playback::RecordedRun& run, const std::string& path);

}  // namespace farrier::cli
