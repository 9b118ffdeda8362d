#include "robot/make_estimator.hpp"

#include <utility>

#include "estimation/grey_box_estimator.hpp"
#include "estimation/joint_estimator.hpp"
#include "estimation/valve/valve_flow_estimator.hpp"
#include "robot/joint_model.hpp"

namespace farrier::robot {
namespace {

using Made = Result<std::unique_ptr<estimation::Estimator>>;

Made refused(const Joint& joint, const std::string& why) { return Error{joint.name + ": " + why}; }

/// A regression on what is measured: every method but one that knows the joint's structure.
Made make_regression_estimator(const Joint& joint, const estimation::JointScales& scales) {
  const bool spring = joint.swing_load.stiffness != 0.0 || joint.stance_load.stiffness != 0.0;
  if (spring && !joint.estimator.position) {
    return refused(joint, "its load has a spring, which a regressor without position cannot show: give position: true");
  }
  const control::DiscreteModel prior = model_of(joint, joint.swing_load, scales.period_s);
  auto estimator = estimation::JointEstimator::create(joint.estimator, scales, prior.a, prior.b);
  if (!estimator) {
    return refused(joint, estimator.error().message);
  }
  return Made(std::make_unique<estimation::JointEstimator>(std::move(estimator).value()));
}

/// Coulomb friction of the piston's seals that the joint's file has, N or Nm; 0 for none.
double seal_friction(const Joint& joint) {
  const plant::ActiveEffect* known = plant::find(joint.effects, plant::effect_id<plant::PistonFriction>());
  return known != nullptr ? plant::parameter_value(*known, "coulomb_N").value_or(0.0) : 0.0;
}

/// Knows the joint's structure, so it needs the actuator and both loads.
Made make_grey_box_estimator(const Joint& joint, const estimation::JointScales& scales) {
  auto estimator = estimation::GreyBoxEstimator::create(
      joint.estimator, scales, joint.actuator, {joint.swing_load, joint.stance_load},
      {.leakage = nominal_physics(joint, joint.swing_load).leakage, .seal_friction = seal_friction(joint)});
  if (!estimator) {
    return refused(joint, estimator.error().message);
  }
  return Made(std::make_unique<estimation::GreyBoxEstimator>(std::move(estimator).value()));
}

/// Knows valve and oil, and needs the loads for its linear model alone.
Made make_valve_flow_estimator(const Joint& joint, const estimation::JointScales& scales) {
  const plant::JointPhysics physics = nominal_physics(joint, joint.swing_load);
  estimation::KnownValve known{.leakage = physics.leakage, .overlap_A = physics.overlap_A, .spool = {}};
  if (const plant::ActiveEffect* spool = plant::find(joint.effects, plant::effect_id<plant::ValveDynamics>())) {
    known.spool = plant::ValveDynamics<double>(spool->values[0], spool->values[1], scales.period_s);
  }
  auto estimator = estimation::ValveFlowEstimator::create(joint.estimator, scales, joint.actuator,
                                                          {joint.swing_load, joint.stance_load}, known);
  if (!estimator) {
    return refused(joint, estimator.error().message);
  }
  return Made(std::make_unique<estimation::ValveFlowEstimator>(std::move(estimator).value()));
}

}  // namespace

estimation::JointScales estimator_scales(const Joint& joint, double period_s, int loop_delay_ticks) {
  const control::Normalisation& n = joint.normalisation;
  return {.state = {n.position, n.velocity, n.force},
          .current_A = n.current_A,
          .sensor_noise = {joint.noise.position, joint.noise.velocity, joint.noise.force},
          .home_position = joint.linkage.position(joint.home_angle_rad),
          .period_s = period_s,
          .input_delay_ticks = loop_delay_ticks};
}

Made make_estimator(const Joint& joint, double period_s, int loop_delay_ticks) {
  const estimation::JointScales scales = estimator_scales(joint, period_s, loop_delay_ticks);
  switch (joint.estimator.method) {
    case estimation::EstimationMethod::kGreyBox:
      return make_grey_box_estimator(joint, scales);
    case estimation::EstimationMethod::kValveFlow:
      return make_valve_flow_estimator(joint, scales);
    default:
      return make_regression_estimator(joint, scales);
  }
}

}  // namespace farrier::robot
