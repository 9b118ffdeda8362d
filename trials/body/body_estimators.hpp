#pragma once

// Estimators of the joints of a robot that walks on its hydraulic joints, and what adaptation does with them.

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "estimation/estimator.hpp"
#include "robot/robot.hpp"
#include "trials/body/compared_runs.hpp"

namespace farrier::trials {

/// Estimates of all joints at one place of a leg, in one phase.
struct EstimateScore {
  int estimates = 0;
  int usable = 0;                                                  ///< with a validity above 0: no flag forbids them
  int valid = 0;                                                   ///< with at least validity_min
  std::array<int, std::size(estimation::kEstimateFlags)> flags{};  ///< estimates with each of these flags
  /// Medians of the usable estimates over the truth; 0 without any. A linear method is held against the joint's model for
  /// the load of the mass matrix: by the entry from current to force, and that from velocity to force. Its load is the
  /// inverse of the entry from force to velocity. The grey box is held against valve gain, bulk modulus and load mass.
  double valve_ratio = 0.0, oil_ratio = 0.0, load_ratio = 0.0;
  double misfit = 0.0;  ///< median of the usable estimates' prediction_error
  /// RMS error of the predicted change of the true force over one tick, by the RMS change; 1 predicts no change.
  double force_error = 0.0;
};

/// By place in the leg and phase.
using EstimateScores = std::array<PerPhase<EstimateScore>, body::kJointsPerLeg>;

struct EstimatorResult {
  std::string name;     ///< of the method
  std::string refusal;  ///< why it has no scores; empty: it has
  EstimateScores scores{};
};

/// Every method, as the robot's joints have it: the linear ones with the parameters of the file's, the grey box with
/// those of the section `greybox`, which `with_grey_box` has. All learn from the same walk of 20 s at 0.4 m/s under the
/// controller of the file. Its gains do not adapt. Stops with fewer results when `keep_on` says false.
std::vector<EstimatorResult> score_estimators(const robot::Robot& on_ground, const robot::Robot& with_grey_box,
                                              std::uint64_t seed, const std::function<bool()>& keep_on);

/// Runs of one robot whose gains adapt, or do not.
struct AdaptingResult {
  std::string controller, estimator;  ///< estimator empty: gains are fixed
  ComparedRuns runs;
};

/// A robot under comparison.
struct AdaptingRobot {
  std::string controller, estimator;
  robot::Robot robot;
  bool adapts = true;
};

/// Feedback linearisation of the file with its estimator; LQR with fixed gains and with every linear method; flow
/// inversion with nominal physics and with the grey box.
std::vector<AdaptingRobot> adapting_robots(const robot::Robot& on_ground, const robot::Robot& with_grey_box);

/// compare_runs of each. Stops when `done` says false; then the results are those of the robots that ended.
std::vector<AdaptingResult> adapt_on_body(std::span<const AdaptingRobot> robots, int seeds,
                                          const std::function<bool()>& done);

}  // namespace farrier::trials
