#include "robot/checks/adaptation_check.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::robot {
namespace {

int jitter_ticks(const RobotFile& file) {
  constexpr double kRounding = 1e-9;  // of a tick
  return static_cast<int>(std::ceil(file.gait.touchdown_jitter_s / file.period_s - kRounding));
}

void check_estimator(const RobotFile& file, const EstimatorSection& estimator, config::Problems& problems) {
  const EstimatorParams& e = estimator.params;
  if (e.blank_ticks < jitter_ticks(file)) {
    problems.push_back(estimator.place.problem(
        "blank_ticks", "is " + std::to_string(e.blank_ticks) + ", but jitter of the touchdowns reaches into the "
                       "samples: give at least " + std::to_string(jitter_ticks(file)) +
                       ", which is gait.touchdown_jitter_s, or more"));
  }
  if (e.operating_point_order > 0 && e.operating_point_time_constant_s < file.period_s) {
    problems.push_back(estimator.place.problem("operating_point_time_constant_s",
                                               "is shorter than period_s: give at least a period"));
  }
}

void check_update_logic(const RobotFile& file, config::Problems& problems) {
  const UpdateLogicSection& logic = file.update_logic;
  const int converged = logic.params.converged_ticks;
  if (converged % file.estimate_period_ticks == 0) {
    return;
  }
  const std::string period = std::to_string(file.estimate_period_ticks);
  problems.push_back(logic.place.where.empty()
                         ? file.place.problem("estimate_period_ticks",
                                              period + " does not divide update_logic.converged_ticks, which is " +
                                                  std::to_string(converged))
                         : logic.place.problem("converged_ticks", std::to_string(converged) +
                                                                      " is not a multiple of estimate_period_ticks: " +
                                                                      "give one of " + period));
}

}  // namespace

void add_default_estimator(RobotFile& file) {
  if (config::find(file.estimators, kDefaultEstimator) != nullptr) {
    return;
  }
  EstimatorSection section;
  section.params.blank_ticks = std::max(section.params.blank_ticks, jitter_ticks(file));
  section.place = file.place;
  section.place.where = std::string("estimators.") + kDefaultEstimator;
  file.estimators.emplace_back(kDefaultEstimator, std::move(section));
}

config::Problems check_adaptation(const RobotFile& file) {
  config::Problems problems;
  for (const auto& [name, estimator] : file.estimators) {
    check_estimator(file, estimator, problems);
  }
  check_update_logic(file, problems);
  return problems;
}

}  // namespace farrier::robot
