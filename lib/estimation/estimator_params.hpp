#pragma once

namespace farrier::estimation {

/// How one joint's dynamics are estimated: recursive least squares with forgetting (Hubacher 2014, 6.1-6.2) on
/// normalised states and input, (3.52), (3.53). The regressor is velocity, force and current, and what is switched on.
/// Why each is there, with what it was measured to do: docs/adaptation.md.
struct EstimatorParams {
  double forgetting_factor = 0.998;  ///< lambda of (6.21), (0, 1]
  bool bias = true;                  ///< a constant in the regressor, for forces no state explains
  bool position = true;              ///< the position in the regressor; a joint without a spring does not need it
  double operating_point_time_constant_s = 0.006;  ///< of the moving mean that is subtracted, >= a period
  int operating_point_order = 2;     ///< times it is subtracted, 0..4; 0: the home pose is subtracted instead
  double full_weight_norm = 0.006;   ///< norm up to which a regressor has full weight, > 0; larger ones are scaled to it
  double innovation_forgetting = 0.9;  ///< of the prediction errors' variance, which weighs states against sensors
  double initial_covariance = 1e5;   ///< of every parameter
  double covariance_limit = 1e6;     ///< of the covariance's trace (6.23)
  double regressor_min = 0.0;        ///< norm below which a sample says nothing (6.24)
  int blank_ticks = 22;              ///< no samples this long after a switch of phase
  int min_samples = 40;              ///< before the first estimate of a phase
  double stability_limit = 0.9999;   ///< modulus to which an unstable pole of an estimate is mapped (8.1.1)
  bool phase_memory = true;          ///< what is known of each phase is kept apart

  /// Length of the regressor, 3 to 5.
  int columns() const noexcept { return 3 + (position ? 1 : 0) + (bias ? 1 : 0); }
};

}  // namespace farrier::estimation
