#include "estimator_service/estimator_service.hpp"

#include "control/model/model_rows.hpp"
#include "robot/make_estimator.hpp"
#include "robot/sensor_path.hpp"

namespace farrier::estimator_service {

Result<EstimatorService> EstimatorService::create(const robot::Robot& robot, int loop_delay_ticks) {
  std::vector<std::unique_ptr<estimation::Estimator>> estimators;
  std::vector<Inputs> inputs;
  for (const robot::Joint& joint : robot.joints) {
    estimators.push_back(FARRIER_TRY(robot::make_estimator(joint, robot.period_s, loop_delay_ticks)));
    // A valve that is estimated is not taken for known.
    inputs.push_back(
        {joint.estimator.finds_valve() ? control::ValveOpening() : control::ValveOpening(joint.effects, joint.actuator),
         robot::signal_aligner(joint, robot.period_s)});
  }
  return EstimatorService(std::move(estimators), std::move(inputs));
}

EstimatorService::EstimatorService(const EstimatorService& other)
    : inputs_(other.inputs_), taken_(other.taken_), supply_Pa_(other.supply_Pa_) {
  for (const auto& estimator : other.estimators_) {
    estimators_.push_back(estimator->clone());
  }
}

void EstimatorService::take(const signals::JointMeasurement& measurement) noexcept {
  if (measurement.joint >= estimators_.size()) {
    return;
  }
  taken_[measurement.joint].add(measurement.tick);
  Inputs& inputs = inputs_[measurement.joint];
  if (measurement.tick != inputs.newest + 1) {
    inputs.aligner.reset();
  }
  inputs.newest = measurement.tick;
  const auto [measured, current_A] = inputs.aligner.take(
      {{measurement.position_m_or_rad, measurement.velocity_m_s_or_rad_s, measurement.force_N_or_Nm},
       inputs.valve.at(measurement.valve_current_A)});
  estimators_[measurement.joint]->take({.tick = measurement.tick,
                                        .state = {measured.position, measured.velocity, measured.force},
                                        .current_A = current_A,
                                        .phase = static_cast<int>(measurement.phase),
                                        .force_error = measurement.force_reference_N_or_Nm - measurement.force_N_or_Nm,
                                        .supply_pressure_Pa = supply_Pa_});
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
