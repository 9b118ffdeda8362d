#pragma once

#include <string>

#include "diagnosis/model/joint_model.hpp"
#include "diagnosis/model/twin.hpp"

namespace farrier::diagnosis {

/// The experiment that would tell two models apart: of sines and steps of the current, the one under which their
/// simulated joints differ most.
struct Experiment {
  plant::EffectId one, other;
  std::string excitation;  ///< "sine" or "steps"
  double amplitude_A, frequency_Hz, duration_s;
  double difference;  ///< largest rms difference of force, position or velocity, over that sensor's noise
};

/// Simulates both hypotheses, which differ in their last effect, from rest at `position`. `other` may have no effect at all.
/// Leaves out excitations that drive a joint out of the middle nine tenths of its stroke; difference 0 when none is left.
Experiment telling_experiment(const JointModel& joint, const Hypothesis& one, const Hypothesis& other,
                              const SensorNoiseLevels& noise, double position);

}  // namespace farrier::diagnosis
