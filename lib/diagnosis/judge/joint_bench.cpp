#include "diagnosis/judge/joint_bench.hpp"

#include <cmath>

#include "diagnosis/data/sample_statistics.hpp"
#include "diagnosis/model/sides_of_joint.hpp"

namespace farrier::diagnosis {
namespace {

/// Least ratio of a recording's signals to its sensors' noise: below it nothing can be judged.
constexpr double kLeastExcitation = 10.0;

ChannelMask judged_channels(const Recording& recording) {
  return {!recording.valve_current_A.empty(), true, !recording.velocity_derived};
}

}  // namespace

SensorNoiseLevels JointBench::noise_of(const Recording& recording, const robot::Joint& joint) {
  const double velocity_noise = recording.velocity_derived ? recording.derived_velocity_noise : joint.noise.velocity;
  return {std::hypot(joint.noise.position, recording.position_error),
          std::hypot(velocity_noise, recording.velocity_error), std::hypot(joint.noise.force, recording.force_error)};
}

bool JointBench::is_excited(const Recording& recording, const SensorNoiseLevels& noise) {
  return standard_deviation(recording.position) > kLeastExcitation * noise.position ||
         standard_deviation(recording.force) > kLeastExcitation * noise.force;
}

JointBench::JointBench(const Recording& recording, const robot::Joint& joint, const FitOptions& options)
    : noise_(noise_of(recording, joint)),
      sides_(sides_of(joint)),
      data_(sides_->prepared(recording, noise_.position)),
      simulator_(*sides_, data_, noise_.force),
      bench_(simulator_, judged_channels(recording), options) {}

ExpectedResiduals JointBench::expected() const {
  return [this](const Hypothesis& hypothesis) { return expected_residuals(bench_, simulator_, hypothesis, noise_); };
}

std::array<double, kChannels> JointBench::expected_of(const Model& model) const {
  return expected()(hypothesis_of(model));
}

}  // namespace farrier::diagnosis
