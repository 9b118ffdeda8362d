#pragma once

// The adaptation of a robot's joints without a bus, at the ticks of lock-step:
//
//   joint/measurement of tick k ──▶ EstimatorService ──▶ joint/model_estimate ──▶ Supervisor in tick k + 1 ──▶ gains.

#include <vector>

#include "estimator_service/estimator_service.hpp"
#include "robot/robot.hpp"
#include "supervisor/supervisor.hpp"

namespace farrier::trials {

/// Estimates that the supervisor judged, and the results.
struct AdaptationCounts {
  int estimates = 0;
  int valid = 0;            ///< with at least validity_min
  int updates = 0;          ///< accepted
  int refused = 0;          ///< designs refused, once for each reason
  int invalid_updates = 0;  ///< accepted from an estimate below validity_min
  int gains_refused = 0;    ///< accepted, but refused by the joint's own check

  AdaptationCounts& operator+=(const AdaptationCounts& other) noexcept;
};

class JointAdaptation {
 public:
  /// Refuses what EstimatorService and Supervisor refuse.
  static Result<JointAdaptation> create(const robot::Robot& robot, std::uint64_t session);

  /// Runs the supervisor's step of a tick. Returns the gains that it issues; at tick 0 the first ones.
  const std::vector<signals::JointControllerGains>& begin(Tick tick) noexcept;
  void take(const signals::JointMeasurement& measurement) noexcept { service_.take(measurement); }
  void take(const signals::SupplyState& supply) noexcept { service_.take(supply); }
  /// Ends a tick after its last measurement.
  void end(Tick tick) noexcept;
  void refused_by_joint() noexcept { ++counts_.gains_refused; }

  const AdaptationCounts& counts() const noexcept { return counts_; }

 private:
  JointAdaptation(const robot::Robot& robot, estimator_service::EstimatorService service,
                  supervisor::Supervisor supervisor);

  double validity_min_;
  int estimate_period_ticks_;
  estimator_service::EstimatorService service_;
  supervisor::Supervisor supervisor_;
  std::vector<signals::JointModelEstimate> estimates_;  // of the last tick, by joint
  bool due_ = false;                                    // they are not judged yet
  AdaptationCounts counts_;
};

}  // namespace farrier::trials
