#pragma once

#include <functional>
#include <vector>

#include "diagnosis/data/recording.hpp"
#include "plant/hydraulic_joint.hpp"
#include "tests/unit/robot/test_files.hpp"

namespace farrier::diagnosis {

inline const robot::Joint& rig() {
  static const robot::Robot robot = robot::load_shipped("fc1d");
  return robot.joints.front();
}

/// The rig on `load` under a current that is `command` of the tick, held near mid-stroke, as its sensors would read it
/// without noise. `effects` are those of the plant.
inline Recording recorded_rig(int ticks, const plant::LoadParams& load, const std::function<double(int)>& command_A,
                              const std::vector<plant::ActiveEffect>& effects = {}) {
  constexpr double kMiddle_m = 0.04;
  auto joint =
      plant::HydraulicJoint::create(rig().actuator, load, plant::equilibrium(rig().actuator, load, kMiddle_m, 0.0),
                                    plant::HydraulicJoint::kDefaultTolerance, effects)
          .value();
  Recording recording;
  recording.period_s = 0.001;
  for (int k = 0; k < ticks; ++k) {
    const double current_A = command_A(k) - 0.05 * (joint.state().position - kMiddle_m);
    recording.valve_current_A.push_back(current_A);
    recording.position.push_back(joint.state().position);
    recording.velocity.push_back(joint.state().velocity);
    recording.force.push_back(joint.load_cell_force());
    joint.step(current_A, 0.0, recording.period_s);
  }
  return recording;
}

}  // namespace farrier::diagnosis
