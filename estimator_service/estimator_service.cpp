#include "estimator_service/estimator_service.hpp"

#include "control/model/model_rows.hpp"
#include "robot/make_estimator.hpp"

namespace farrier::estimator_service {

Result<EstimatorService> EstimatorService::create(const robot::Robot& robot, int loop_delay_ticks) {
  std::vector<std::unique_ptr<estimation::Estimator>> estimators;
  std::vector<control::ValveOpening> valves;
  for (const robot::Joint& joint : robot.joints) {
    estimators.push_back(FARRIER_TRY(robot::make_estimator(joint, robot.period_s, loop_delay_ticks)));
    valves.emplace_back(joint.effects);
  }
  return EstimatorService(std::move(estimators), std::move(valves));
}

EstimatorService::EstimatorService(const EstimatorService& other) : valves_(other.valves_), taken_(other.taken_) {
  for (const auto& estimator : other.estimators_) {
    estimators_.push_back(estimator->clone());
  }
}

void EstimatorService::take(const signals::JointMeasurement& measurement) noexcept {
  if (measurement.joint < estimators_.size()) {
    taken_[measurement.joint].add(measurement.tick);
    estimators_[measurement.joint]->take(
        {.tick = measurement.tick,
         .state = {measurement.position_m_or_rad, measurement.velocity_m_s_or_rad_s, measurement.force_N_or_Nm},
         .current_A = valves_[measurement.joint].at(measurement.valve_current_A),
         .phase = static_cast<int>(measurement.phase)});
  }
}

signals::JointModelEstimate EstimatorService::estimate(std::uint16_t joint, Tick tick) const noexcept {
  signals::JointModelEstimate signal;
  signal.joint = joint;
  signal.tick = tick;
  if (joint >= estimators_.size()) {
    return signal;
  }
  signal.measurements = taken_[joint].bits_at(tick);
  const estimation::ModelEstimate estimate = estimators_[joint]->estimate();
  signal.phase = static_cast<Phase>(estimate.phase);
  signal.a = control::rows_of(estimate.a);
  signal.b = control::entries_of(estimate.b);
  signal.c = control::entries_of(estimate.c);
  signal.a_error = control::rows_of(estimate.a_error);
  signal.b_error = control::entries_of(estimate.b_error);
  signal.validity = estimate.validity;
  signal.excitation = estimate.excitation;
  signal.prediction_error = estimate.prediction_error;
  signal.whiteness = estimate.whiteness;
  signal.samples = estimate.samples;
  signal.flags = estimate.flags;
  signal.has_physics = estimate.has_physics ? 1 : 0;
  signal.physics = plant::values_of(estimate.physics);
  signal.physics_error = plant::values_of(estimate.physics_error);
  return signal;
}

}  // namespace farrier::estimator_service
