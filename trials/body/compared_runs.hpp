#pragma once

// The runs by which robots on a ground are compared.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trials/body/trot_trial.hpp"

namespace farrier::trials {

/// Walks of 20 s on flat ground at 0.4 m/s, then walks up a step of 10 cm, `seeds` of each.
std::vector<TrotCase> compared_cases(const robot::Robot& robot, int seeds);

/// Falls and errors of the runs of one robot.
struct ComparedRuns {
  std::string refusal = {};  ///< why it has no runs; empty: it has
  int walks = 0, walk_falls = 0;
  int steps = 0, step_falls = 0;
  ForceErrors force_nrmse{};      ///< median over the walks without a fall; 0 if all fell
  double height_rms_m = 0.0;      ///< likewise
  AdaptationCounts adaptation{};  ///< sum over the runs; 0 of gains that do not adapt
};

/// Runs the compared cases of a robot on its actuators. Tells `done` after each run and ends with nothing when it says
/// false.
std::optional<ComparedRuns> compare_runs(const robot::Robot& robot, int seeds, bool adapts,
                                         const std::function<bool()>& done);

}  // namespace farrier::trials
