#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/robot.hpp"

namespace farrier::cli {

/// Healthy robots of `farrier diagnose --benchmark --healthy`, 12 joints each.
inline constexpr int kHealthyRobots = 300;

/// Options of `farrier diagnose --benchmark`.
struct DiagnoseBenchmark {
  std::string json_path;       ///< empty: none
  std::string confusion_path;  ///< Markdown of what was taken for what; empty: none
  std::uint64_t seed = 1;
  int trials = 0;  ///< the first in a mixed order; 0: all
  int threads = 2;
  bool electric = false;  ///< trials of electric joints
  bool healthy = false;   ///< trials of whole robots that hide nothing; `trials` counts robots, 0: kHealthyRobots
  std::string calibration_path;  ///< where the map of confidences goes that these trials give; empty: none is fitted
  bool go_on = false;            ///< takes the trials over that an earlier run of this build kept beside `json_path`
};

/// Robots of which trials are made: a rig with one cylinder, and legs without the effects of their file. Electric ones:
/// a leg with springs in its joints, and one with rigid drives.
struct TrialRobots {
  robot::Robot rig, legs;

  /// The joints of blind trials: the first of either.
  std::vector<const robot::Joint*> joints() const { return {&rig.joints.front(), &legs.joints.front()}; }
};

/// fc1d.yaml and hyq.yaml of a folder, or electric_leg.yaml and go1.yaml.
Result<TrialRobots> load_trial_robots(const std::string& folder, bool electric = false);

/// Blind trials of the diagnosis on the nominal robots in `robots`, a folder with fc1d.yaml and hyq.yaml. Exit status of
/// the command.
int run_diagnose_benchmark(const DiagnoseBenchmark& options, const std::string& robots);

}  // namespace farrier::cli
