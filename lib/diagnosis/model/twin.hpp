#pragma once

#include <array>

#include "diagnosis/judge/hypothesis.hpp"
#include "diagnosis/model/joint_simulator.hpp"

namespace farrier::diagnosis {

/// Noise of the sensors of position, velocity and force: standard deviations, m, m/s and N or rad, rad/s and Nm.
struct SensorNoiseLevels {
  double position, velocity, force;
};

/// Root mean square by channel of a model's residuals if it were right and its sensors had `noise`. It comes from a
/// twin, a recording that the model produces itself over the same motion. The `bench` judges hypotheses by `joint`.
std::array<double, kChannels> expected_residuals(const Bench& bench, const JointSimulator& joint,
                                                 const Hypothesis& hypothesis, const SensorNoiseLevels& noise);

}  // namespace farrier::diagnosis
