#pragma once

#include <memory>

#include "diagnosis/data/recording.hpp"
#include "diagnosis/judge/hypothesis.hpp"
#include "diagnosis/judge/remainder.hpp"
#include "diagnosis/model/twin.hpp"
#include "robot/robot.hpp"

namespace farrier::diagnosis {

/// A recording of a joint, its model, and the bench that judges hypotheses about them.
class JointBench {
 public:
  /// `recording` has no findings of check_recording.
  JointBench(const Recording& recording, const robot::Joint& joint, const FitOptions& options);
  JointBench(const JointBench&) = delete;
  JointBench& operator=(const JointBench&) = delete;

  /// True if position or force rises far enough above its sensor's noise for a judgement.
  static bool is_excited(const Recording& recording, const SensorNoiseLevels& noise);
  static SensorNoiseLevels noise_of(const Recording& recording, const robot::Joint& joint);

  const JointSides& sides() const noexcept { return *sides_; }
  const SensorNoiseLevels& noise() const noexcept { return noise_; }
  const JointSimulator& simulator() const noexcept { return simulator_; }
  const Bench& bench() const noexcept { return bench_; }
  /// Root mean square by channel of residuals if a hypothesis were right, by its sensors' noise.
  ExpectedResiduals expected() const;
  /// The same of a model, without a fit.
  std::array<double, kChannels> expected_of(const Model& model) const;

 private:
  SensorNoiseLevels noise_;
  std::unique_ptr<JointSides> sides_;
  JointData data_;
  JointSimulator simulator_;
  Bench bench_;
};

}  // namespace farrier::diagnosis
