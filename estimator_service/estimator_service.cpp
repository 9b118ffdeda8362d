#include "estimator_service/estimator_service.hpp"

#include <cmath>

namespace farrier::estimator_service {

EstimatorService::EstimatorService(const robot::Robot& robot) {
  for (const robot::Joint& joint : robot.joints) {
    joints_.push_back({joint.number});
  }
}

signals::JointModelEstimate EstimatorService::step(const signals::JointMeasurement& measurement) noexcept {
  signals::JointModelEstimate estimate;
  estimate.joint = measurement.joint;
  estimate.tick = measurement.tick;
  estimate.phase = measurement.phase;
  estimate.flags = static_cast<std::uint32_t>(EstimateFlag::kNotEstimating);
  for (Joint& joint : joints_) {
    if (joint.number == measurement.joint && std::isfinite(measurement.position_m_or_rad) &&
        std::isfinite(measurement.velocity_m_s_or_rad_s) && std::isfinite(measurement.force_N_or_Nm)) {
      ++joint.usable;
    }
  }
  return estimate;
}

std::uint64_t EstimatorService::usable_measurements(std::uint16_t number) const noexcept {
  for (const Joint& joint : joints_) {
    if (joint.number == number) {
      return joint.usable;
    }
  }
  return 0;
}

}  // namespace farrier::estimator_service
