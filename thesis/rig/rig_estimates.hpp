#pragma once

// The recursive estimator of Hubacher (2014), Chapter 6, on chirps of the valve current: what Figs 9.1 to 9.10 and G.1
// to G.6 draw.

#include <Eigen/Core>

#include <vector>

#include "control/model/discretise.hpp"
#include "estimation/estimator_params.hpp"
#include "thesis/rig/rig_run.hpp"

namespace farrier::thesis {

inline constexpr double kChirp_s = 8.0;
inline constexpr double kChirp_Hz = 30.0;

/// Position of the piston at the beginning, from mid-stroke. The text does not give it. A chirp drives the cylinder,
/// whose sides differ, outwards by some 12 mm in 8 s. From here the largest singular value of Fig. 9.6 falls at first
/// and rises at the end, as the text has it.
inline constexpr double kStart_m = -0.010;

/// A chirp of 0 to 30 Hz in 8 s, and who learns from it.
struct ChirpCase {
  double amplitude = 0.2;  ///< of the nominal valve opening
  double added_kg = 0.0;
  estimation::EstimationMethod method = estimation::EstimationMethod::kAff;  ///< kAff, or kRls with lambda = 0.92
  estimation::GateKind gate = estimation::GateKind::kNone;
  int frequencies_min = 28;         ///< f_min of (9.5); a gate is tuned for each experiment (9.1.5)
  double initial_covariance = 1e5;  ///< nothing is known
};

/// The chirp of Figs 9.8 to 9.10 with weight on the cart, learned from with adaptive forgetting. The text gives no
/// amplitude: 20 %, of its three the one that excites most.
ChirpCase weighted_chirp(double added_kg, estimation::GateKind gate);

/// Everything of one case. Models are normalised, (3.52), (3.53), states from mid-stroke.
struct ChirpEstimates {
  double period_s = 0.0;
  control::DiscreteModel first;    ///< where the estimator began: intentionally wrong
  control::DiscreteModel nominal;  ///< (3.51) at rest, of the load that was on the cart
  std::vector<double> time_s;      ///< of the models, one every kModel_s
  std::vector<control::DiscreteModel> models;
  std::vector<bool> learning;  ///< whether the gate was open when each was taken
  // A value a tick:
  std::vector<double> tick_s;
  std::vector<Eigen::Vector3d> forgetting;  ///< lambda of the rows of position, velocity, force
  std::vector<Eigen::Vector3d> error;       ///< y - H Theta before the sample is learned from, normalised
  std::vector<bool> open;
  std::vector<Eigen::Vector2d> singular_values;  ///< smallest and largest, of a PE gate
  std::vector<int> frequencies;                  ///< above the threshold, of an FFT gate
};

inline constexpr double kModel_s = 0.02;

/// (6.21) with the regressor (x, v, F, u) of Section 6.2: every row is estimated, nothing is washed out or filtered.
/// Refuses what track() and the estimators refuse.
Result<ChirpEstimates> estimate_chirp(const robot::Robot& rig, const ChirpCase& one, std::uint64_t seed);

/// The settings of a case: those of the gates are what 9.1.2 calls tuning parameters, those that have a size found at an
/// amplitude of 10 % and in proportion to its power or to itself.
estimation::EstimatorParams params_of(const ChirpCase& one);

}  // namespace farrier::thesis
