#include "tools/recording/identify.hpp"

#include "estimator_service/estimator_service.hpp"

namespace farrier::recording {

Result<Done> identify(const Measurements& measured, const robot::Robot& robot,
                      const std::function<void(const signals::JointModelEstimate&)>& take) {
  auto service = estimator_service::EstimatorService::create(robot, measured.loop_delay_ticks(robot));
  if (!service) {
    return service.error();
  }
  for (const std::vector<signals::JointMeasurement>& joint : measured.joints) {
    for (const signals::JointMeasurement& measurement : joint) {
      service.value().take(measurement);
      if (robot.estimate_due(measurement.tick)) {
        take(service.value().estimate(measurement.joint, measurement.tick));
      }
    }
  }
  return Done{};
}

}  // namespace farrier::recording
