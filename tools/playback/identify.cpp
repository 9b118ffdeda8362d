#include "tools/playback/identify.hpp"

#include "estimator_service/estimator_service.hpp"

namespace farrier::playback {
namespace {

constexpr std::size_t kAskEveryMeasurements = 1000;  // measurements

}  // namespace

Result<Done> identify(const Measurements& measured, const robot::Robot& robot,
                      const std::function<void(const signals::JointModelEstimate&)>& take, const KeepOn& keep_on) {
  auto service = FARRIER_TRY(estimator_service::EstimatorService::create(robot, measured.loop_delay_ticks(robot)));
  std::size_t all = 0, fed = 0;
  for (const std::vector<signals::JointMeasurement>& joint : measured.joints) {
    all += joint.size();
  }
  for (const std::vector<signals::JointMeasurement>& joint : measured.joints) {
    for (const signals::JointMeasurement& measurement : joint) {
      if (keep_on && fed % kAskEveryMeasurements == 0 && !keep_on(static_cast<double>(fed) / static_cast<double>(all))) {
        return Error{recording::kInterrupted};
      }
      ++fed;
      service.take(measurement);
      if (robot.estimate_due(measurement.tick)) {
        take(service.estimate(measurement.joint, measurement.tick));
      }
    }
  }
  return Done{};
}

}  // namespace farrier::playback
