#pragma once

// One estimator per leg joint:
//
//   joint/measurement ──▶ Estimator of that joint ──▶ joint/model_estimate (every estimate_period_ticks)
//                                                 └──▶ lf/joint/model_estimate (ten a second)

#include <memory>
#include <vector>

#include "estimation/estimator.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"

namespace farrier::estimator_service {

/// The service's core. No clock, no I/O, no allocation after construction.
class EstimatorService {
 public:
  /// Every estimator starts from the joint's swing load in both phases, and knows that a command acts
  /// `loop_delay_ticks` after the sample it answers. Refuses estimator settings out of range, naming the joint.
  static Result<EstimatorService> create(const robot::Robot& robot, int loop_delay_ticks);

  /// A copy knows what this one does, and learns by itself.
  EstimatorService(const EstimatorService& other);
  EstimatorService& operator=(const EstimatorService& other) { return *this = EstimatorService(other); }
  EstimatorService(EstimatorService&&) noexcept = default;
  EstimatorService& operator=(EstimatorService&&) noexcept = default;
  ~EstimatorService() = default;

  /// Takes one joint's measurement. Measurements of joints the robot does not have are left out.
  void take(const signals::JointMeasurement& measurement) noexcept;

  /// Present estimate of a joint, as of `tick`. Not an estimate for a joint the robot does not have.
  signals::JointModelEstimate estimate(std::uint16_t joint, Tick tick) const noexcept;

 private:
  explicit EstimatorService(std::vector<std::unique_ptr<estimation::Estimator>> estimators)
      : estimators_(std::move(estimators)) {}

  std::vector<std::unique_ptr<estimation::Estimator>> estimators_;  // by joint number
};

}  // namespace farrier::estimator_service
