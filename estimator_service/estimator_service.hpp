#pragma once

// One estimator per leg joint:
//
//   joint/measurement ──▶ estimator of that joint ──▶ joint/model_estimate (every estimate_period_ticks)
//
// The estimators do not estimate yet: each report says so by validity 0 and the flag kNotEstimating.

#include <vector>

#include "robot/robot.hpp"
#include "signals/signals.hpp"

namespace farrier::estimator_service {

/// Flags of a model estimate (thesis Table F.1 where it has one).
enum class EstimateFlag : std::uint32_t {
  kNotEstimating = 1u << 0,  ///< no estimator runs for this joint
};

/// The service's core: holds one estimator's state per joint. No clock, no I/O, no allocation after construction.
class EstimatorService {
 public:
  explicit EstimatorService(const robot::Robot& robot);

  /// Takes one joint's measurement; returns its present estimate.
  signals::JointModelEstimate step(const signals::JointMeasurement& measurement) noexcept;

  /// Measurements taken of a joint that were finite.
  std::uint64_t usable_measurements(std::uint16_t joint) const noexcept;

 private:
  struct Joint {
    std::uint16_t number;
    std::uint64_t usable = 0;
  };
  std::vector<Joint> joints_;
};

}  // namespace farrier::estimator_service
