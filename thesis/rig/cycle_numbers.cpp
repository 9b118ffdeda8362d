#include "thesis/rig/cycle_numbers.hpp"

#include <string>

#include "robot/joint_model.hpp"

namespace farrier::thesis {

using signals::JointControllerGains;

namespace {

/// Time after the beginning of quarter 2 from which on the gains stay near those for its true load.
double settled_s(const CycleRun& run, const TrueGains& truth) {
  constexpr double kNear = 0.25;
  const auto between = [](double value, double extending, double retracting) {
    return value / extending >= 1.0 - kNear && value / retracting <= 1.0 + kNear;
  };
  const auto near = [&](const JointControllerGains& gains) {
    return between(gains.k_velocity, truth.extending.velocity, truth.retracting.velocity) &&
           between(gains.k_force, truth.extending.force, truth.retracting.force);
  };
  Tick last_off = run.cycle.begin[1] - 1;
  for (Tick tick = run.cycle.begin[1]; tick < run.cycle.begin[2]; ++tick) {
    last_off = near(acting_before(run, tick + 1)) ? last_off : tick;
  }
  return static_cast<double>(last_off + 1 - run.cycle.begin[1]) * run.cycle.robot.period_s;
}

}  // namespace

Result<TrueGains> true_gains(const robot::Robot& robot, const plant::LoadParams& load) {
  const robot::Joint& joint = robot.joints[0];
  const auto of_sign = [&](double sign) {
    return control::design(robot::model_of(joint, load, robot.period_s, {.valve_sign = sign}), joint.design,
                           joint.normalisation, joint.form, 0, robot.period_s);
  };
  const auto extending = of_sign(1.0);
  const auto retracting = of_sign(-1.0);
  if (!extending || !retracting) {
    return Error{"Fig. 7.8: no design for " + std::to_string(load.mass) + " kg"};
  }
  return TrueGains{extending.value(), retracting.value()};
}

Result<CycleNumbers> numbers_of(const CycleRun& run, const CycleRun& fixed) {
  CycleNumbers numbers{.error = {},
                       .improvement = {},
                       .second = at_end_of(run, 2),
                       .third = at_end_of(run, 3),
                       .fourth = at_end_of(run, 4)};
  for (std::size_t i = 0; i < trials::kQuarters; ++i) {
    numbers.error[i] = quarter_error(run, i + 1);
    numbers.improvement[i] = numbers.error[i] / quarter_error(fixed, i + 1);
  }
  for (const JointControllerGains& gains : run.gains) {
    if (numbers.first_update_s < 0.0 && gains.generation > run.gains.front().generation) {
      numbers.first_update_s = static_cast<double>(gains.effective_tick) * run.cycle.robot.period_s;
      numbers.at_once = error_from(run, gains.effective_tick) / error_from(fixed, gains.effective_tick);
    }
  }
  numbers.second_lag_deg = quarter_lag_deg(run, 2);
  numbers.second_overshoot = quarter_overshoot(run, 2);
  numbers.settled_s = settled_s(run, FARRIER_TRY(true_gains(run.cycle.robot, run.cycle.loads[1])));
  return numbers;
}

}  // namespace farrier::thesis
