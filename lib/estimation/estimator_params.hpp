#pragma once

#include <optional>

#include "core/choice.hpp"
#include "estimation/grey_box_params.hpp"
#include "estimation/valve_flow_params.hpp"

namespace farrier::estimation {

/// Method that learns the model. docs/estimators.md compares the methods and says when to choose which.
enum class EstimationMethod { kRls, kAff, kKalman, kIv, kVdf, kSift, kGreyBox, kValveFlow };

/// Every method, by its name in a robot file.
inline constexpr Option<EstimationMethod> kEstimationMethods[] = {
    {"rls", EstimationMethod::kRls},         {"aff", EstimationMethod::kAff},
    {"kalman", EstimationMethod::kKalman},   {"iv", EstimationMethod::kIv},
    {"vdf", EstimationMethod::kVdf},         {"sift", EstimationMethod::kSift},
    {"greybox", EstimationMethod::kGreyBox}, {"valve_flow", EstimationMethod::kValveFlow}};

/// Test that decides if a sample may teach.
enum class GateKind { kNone, kPe, kFft };

/// aff: Hubacher (2014), (9.1)-(9.3).
struct AdaptiveForgettingParams {
  double forgetting_min = 0.8;  ///< least lambda of a row, (0, 1]; the method's own least is 1 - 2 / (3 N)
  double noise_factor = 4.0;    ///< c_1: variances of the sensors' noise that are no reason to forget, >= 0
  double error_memory = 0.9;    ///< beta of (9.2), [0, 1)
};

/// kalman: Hubacher (2014), (B.16), (B.17).
struct RandomWalkParams {
  double parameter_drift = 1.0;  ///< variance of a parameter's step from tick to tick over that of the noise, >= 0
};

/// vdf, sift: threshold of excitation, [1e-20, 1e20].
struct VariableDirectionParams {
  double excitation_min = 1e-4;  ///< of the regressor's share along an eigenvector of the information matrix
};
struct SubspaceParams {
  double excitation_min = 1e-3;  ///< of the regressor's norm
};

/// pe: Hubacher (2014), (9.4) corrected.
struct PersistenceParams {
  int window_ticks = 100;         ///< N, 8..4096
  double information_min = 1e-7;  ///< alpha, least singular value of sum h h', >= 0
  double information_max = 1e6;   ///< beta, largest, above alpha
};

/// fft: Hubacher (2014), (9.5).
struct SpectrumParams {
  int window_ticks = 64;        ///< N, 8..1024, even
  double magnitude_min = 1e-3;  ///< M_min, of an amplitude of a normalised signal, > 0
  int frequencies_min = 6;      ///< f_min: number of the N/2 - 1 frequencies of all signals that must exceed it
};

/// Settings of one joint's estimator. It is recursive (Hubacher 2014, 6.1-6.2) and works on normalised states and
/// input, (3.52), (3.53). The regressor is velocity, force and current, and the entries switched on below.
/// docs/adaptation.md gives the reason for each and its measured effect.
struct EstimatorParams {
  EstimationMethod method = EstimationMethod::kRls;
  GateKind gate = GateKind::kNone;
  double forgetting_factor = 0.998;  ///< lambda of (6.21), (0, 1]; aff and kalman have rules of their own
  bool bias = true;                  ///< a constant in the regressor, for forces no state explains
  bool position = true;              ///< the position in the regressor; a joint without a spring does not need it
  double operating_point_time_constant_s = 0.006;  ///< of the moving mean that is subtracted, >= a period
  int operating_point_order = 2;    ///< times it is subtracted, 0..4; 0: the home pose is subtracted instead
  double full_weight_norm = 0.006;  ///< norm up to which a regressor has full weight, > 0; larger ones are scaled to it
  double model_error = 1.5e-4;  ///< RMS error per tick of what a linear model leaves out, in velocity and force, >= 0
  double innovation_forgetting = 0.9;  ///< of the prediction errors' variance, which weighs states against sensors
  double initial_covariance = 1e5;     ///< of every parameter
  double covariance_limit = 1e6;       ///< of the covariance's trace (6.23); 1e40: none. vdf and sift need none
  double regressor_min = 0.0;          ///< norm below which a sample is left out (6.24)
  int blank_ticks = 22;                ///< no samples this long after a switch of phase
  int min_samples = 40;                ///< before the first estimate of a phase
  double stability_limit = 0.9999;     ///< modulus to which an unstable pole of an estimate is mapped (8.1.1)
  bool phase_memory = true;            ///< each phase has its own memory
  std::optional<AdaptiveForgettingParams> aff;  ///< of the method and the gate chosen; absent: its defaults
  std::optional<RandomWalkParams> kalman;
  std::optional<VariableDirectionParams> vdf;
  std::optional<SubspaceParams> sift;
  std::optional<GreyBoxParams> grey_box;
  std::optional<ValveFlowParams> valve_flow;
  std::optional<PersistenceParams> pe;
  std::optional<SpectrumParams> fft;

  /// Length of the regressor, 3 to 5.
  int columns() const noexcept { return 3 + (position ? 1 : 0) + (bias ? 1 : 0); }

  /// True if the method regresses on measured states. If not, it uses only blank_ticks, min_samples, phase_memory and its
  /// own group; valve_flow of these only min_samples and its group.
  bool regresses() const noexcept {
    return method != EstimationMethod::kGreyBox && method != EstimationMethod::kValveFlow;
  }

  /// True if the method finds the valve, which others take for known, and keeps the load that others find.
  bool finds_valve() const noexcept { return method == EstimationMethod::kValveFlow; }

  /// True if the method has one lambda, forgetting_factor.
  bool forgets_evenly() const noexcept {
    return regresses() && method != EstimationMethod::kAff && method != EstimationMethod::kKalman;
  }

  /// True if covariance_limit bounds the covariance.
  bool limits_covariance() const noexcept {
    return regresses() && method != EstimationMethod::kVdf && method != EstimationMethod::kSift;
  }
};

}  // namespace farrier::estimation
