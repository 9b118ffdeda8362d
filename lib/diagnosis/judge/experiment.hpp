#pragma once

#include <string>
#include <utility>
#include <vector>

#include "diagnosis/model/joint_sides.hpp"
#include "diagnosis/model/twin.hpp"

namespace farrier::diagnosis {

/// The experiment that would tell two models apart: of sines and steps of the current, the one under which their
/// simulated joints differ most.
struct Experiment {
  plant::EffectId one, other;
  std::string excitation;  ///< "sine" or "steps"
  double amplitude_A, frequency_Hz, duration_s;
  double difference;          ///< largest rms difference of force, position or velocity, over that sensor's noise
  double amplitude_Nm = 0.0;  ///< the same amplitude as a torque of an electric drive; 0 of a valve
  Hold hold = {};             ///< beside which an electric joint's command is given

  /// True if the difference is large enough to tell the two apart.
  bool tells() const noexcept;
};

/// Difference of two simulated joints, over a sensor's noise, from which an experiment tells them apart.
inline constexpr double kTellingDifference = 3.0;
inline bool Experiment::tells() const noexcept { return difference > kTellingDifference; }

/// Current of each period of an experiment, A, beside that of the hold. Steps are levels drawn at random between both
/// amplitudes, held for half a period of the frequency.
std::vector<double> experiment_current_A(const Experiment& experiment, double period_s);

/// Simulates joints of both models, which differ in the `pair` of effects, from rest amid the travel. Leaves out
/// excitations that drive a joint out of the middle nine tenths of its travel, or an electric one beyond eight tenths of
/// its rating; difference 0 if none is left.
Experiment telling_experiment(const JointSides& joint, std::pair<plant::EffectId, plant::EffectId> pair,
                              const Model& one, const Model& other, const SensorNoiseLevels& noise);

}  // namespace farrier::diagnosis
