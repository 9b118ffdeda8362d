#pragma once

// Result of `farrier compare body --estimators`.

#include <span>
#include <string>

#include "report/figures/figures.hpp"
#include "trials/body/body_estimators.hpp"

namespace farrier::report {

/// Adds compare.body.<group>.<method>.<place>.<phase>.*, of methods that were not refused. The group is `estimator`, or
/// `estimator_ideal_valve` of the robot with ideal valves.
void add_estimators(Figures& figures, const std::string& group, std::span<const trials::EstimatorResult> results);

/// For people: a line for each method, place and phase.
std::string estimators_text(std::span<const trials::EstimatorResult> results);

/// Adds compare.body.adapting.<controller>.<estimator>.*, the estimator of fixed gains being `fixed`. No update may come
/// from an estimate that is not valid.
void add_adapting(Figures& figures, std::span<const trials::AdaptingResult> results);

/// For people: a line for each robot.
std::string adapting_text(std::span<const trials::AdaptingResult> results);

}  // namespace farrier::report
