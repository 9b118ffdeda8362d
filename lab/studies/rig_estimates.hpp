#pragma once

// The recursive estimator of Hubacher (2014), Chapter 6, on chirps of the valve current: what Figs 9.1 to 9.10 and G.1
// to G.6 draw.

#include <Eigen/Core>

#include <vector>

#include "control/discretise.hpp"
#include "estimation/estimator_params.hpp"
#include "lab/studies/rig_run.hpp"

namespace farrier::studies {

inline constexpr double kChirp_s = 8.0;
inline constexpr double kChirp_Hz = 30.0;

/// A chirp of 0 to 30 Hz in 8 s, and who learns from it.
struct ChirpCase {
  double amplitude = 0.2;  ///< of the nominal valve opening
  double added_kg = 0.0;
  estimation::EstimationMethod method = estimation::EstimationMethod::kAff;  ///< kAff, or kRls with lambda = 0.92
  estimation::GateKind gate = estimation::GateKind::kNone;
};

/// Everything of one case. Models are normalised, (3.52), (3.53), states from mid-stroke.
struct ChirpEstimates {
  double period_s = 0.0;
  control::DiscreteModel first;                 ///< where the estimator began: intentionally wrong
  control::DiscreteModel nominal;               ///< (3.51) at rest, of the load that was on the cart
  std::vector<double> time_s;                   ///< of the models, one every kModel_s
  std::vector<control::DiscreteModel> models;
  std::vector<bool> learning;                   ///< whether the gate was open when each was taken
  // A value a tick:
  std::vector<double> tick_s;
  std::vector<Eigen::Vector3d> forgetting;      ///< lambda of the rows of position, velocity, force
  std::vector<Eigen::Vector3d> error;           ///< y - H Theta before the sample is learned from, normalised
  std::vector<bool> open;
  std::vector<Eigen::Vector2d> singular_values; ///< smallest and largest, of a PE gate
  std::vector<int> frequencies;                 ///< above the threshold, of an FFT gate
};

inline constexpr double kModel_s = 0.02;

/// (6.21) with the regressor (x, v, F, u) of Section 6.2: every row is estimated, nothing is washed out or filtered.
/// Refuses what track() and the estimators refuse.
Result<ChirpEstimates> estimate_chirp(const robot::Robot& rig, const ChirpCase& one, std::uint64_t seed);

/// The settings of a case: those of the gates are what 9.1.2 calls tuning parameters.
estimation::EstimatorParams params_of(const ChirpCase& one);

/// Frequencies at which the estimates are compared, 0.3 to 200 Hz.
const std::vector<double>& chirp_grid();
/// From normalised valve current to normalised load-cell force.
std::vector<std::complex<double>> force_response(const control::DiscreteModel& model, double period_s);

/// Whether the response has a maximum between 0.3 and 10 Hz that stands 3 dB above what lies to its left and right: a
/// resonance the rig does not have there.
bool has_fictive_peak(const control::DiscreteModel& model, double period_s);
/// Share of the models between two times with such a peak.
double fictive_share(const ChirpEstimates& run, double from_s, double to_s);
/// RMS distance in dB from the nominal response over [from_Hz, to_Hz], mean of the models between two times.
double distance_dB(const ChirpEstimates& run, double from_s, double to_s, double from_Hz = 1.0, double to_Hz = 100.0);
/// That of the first guess.
double first_distance_dB(const ChirpEstimates& run, double from_Hz = 1.0, double to_Hz = 100.0);
/// Mean over the models between two times of the RMS change in dB from the model before.
double roughness_dB(const ChirpEstimates& run, double from_s, double to_s);
/// Spans in which the gate was open, in ticks, those that last less than `shortest` ticks left out.
struct Span {
  std::size_t begin, end;
};
std::vector<Span> open_spans(const ChirpEstimates& run, std::size_t shortest = 1);

/// Magnitude and phase over frequency: estimates from black to yellow, the last one green, the first purple, nominal
/// blue.
std::vector<Panel> estimates_panels(const std::string& title, const ChirpEstimates& run);
/// lambda of the rows, a panel each.
Picture forgetting_picture(const std::string& caption, const ChirpEstimates& run);

}  // namespace farrier::studies
