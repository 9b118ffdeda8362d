#pragma once

#include <string>
#include <vector>

namespace farrier::cli {

/// The command line of `farrier trial body`.
struct BodyTrialOptions {
  std::string robot_path;
  std::string out;
  std::string json_path;          ///< empty: figures.json in `out`
  std::vector<std::string> only;  ///< trials; empty: all
  bool smoke = false;             ///< the first run of each trial
  bool go_on = false;
  int threads = 2;
  bool ideal = false;  ///< the joints follow torques at once
};

/// Runs the trials, prints the table of verdicts and writes figures and runs. Returns the exit status. A build without
/// MuJoCo refuses (without_body.cpp).
int run_body_trials(const BodyTrialOptions& options);

}  // namespace farrier::cli
