#pragma once

#include <map>
#include <string>
#include <vector>

#include "trials/body/trot_trial.hpp"

namespace farrier::cli {

/// Name of a run in messages, and what it is kept by.
std::string key_of(const std::string& trial, const std::string& name);

/// Runs of the whole robot, of which some may have been kept by a command that was interrupted.
class BodyRuns {
 public:
  struct Settings {
    std::string kept_path;  ///< file of the runs that ended
    std::string origin;     ///< what the runs depend on beside their names: build, robots, options
    bool go_on = false;     ///< takes the runs of `kept_path` that have this origin
    trials::Joints joints = trials::Joints::kActuators;
    int threads = 2;
  };

  explicit BodyRuns(Settings settings);

  /// Runs those of the jobs that are not kept, with a bar of that title, until a stop is requested. Returns what came of
  /// the jobs, in their order.
  std::vector<trials::TrotRow> run(const std::string& title, const std::vector<trials::TrotJob>& jobs);

  /// Why some runs are not kept; empty: all are.
  const std::string& not_kept() const noexcept { return not_kept_; }

 private:
  void keep(const trials::TrotRow& row);

  Settings settings_;
  std::map<std::string, trials::TrotRow> rows_;  // by key_of
  std::string not_kept_;
};

}  // namespace farrier::cli
