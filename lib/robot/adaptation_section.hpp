#pragma once

#include "config/visitor.hpp"

namespace farrier::robot {

/// How one joint's dynamics are estimated: recursive least squares with forgetting (Hubacher 2014, 6.1-6.2) on
/// normalised states and input, (3.52), (3.53). The regressor is velocity, force and current, and what is switched on.
struct EstimatorParams {
  double forgetting_factor = 0.995;  ///< lambda of (6.21)
  bool bias = true;                  ///< a constant in the regressor, for forces no state explains
  bool position = true;              ///< the position in the regressor; a joint without a spring does not need it
  double operating_point_time_constant_s = 0.0;  ///< of the mean that is subtracted; 0: the home pose is
  double initial_covariance = 100.0;  ///< of every parameter
  double covariance_limit = 1e5;      ///< of the covariance's trace (6.23)
  double regressor_min = 1e-3;        ///< norm below which a sample says nothing (6.24)
  int blank_ticks = 12;               ///< no samples this long before and after a planned switch of phase
  double stability_limit = 0.9999;    ///< modulus to which an unstable pole of an estimate is mapped (8.1.1)
  bool phase_memory = true;           ///< what is known of each phase is kept apart

  /// Length of the regressor, 3 to 5.
  int columns() const noexcept { return 3 + (position ? 1 : 0) + (bias ? 1 : 0); }
};

/// When an estimate leads to new gains (Hubacher 2014, 8.2.1, Fig. 8.8), and what else new gains must hold.
struct UpdateLogicParams {
  double pole_distance_min = 0.03;  ///< to the poles the acting gains are designed for, z-plane
  double pole_spread_max = 0.02;    ///< of the poles that count as converged, z-plane
  int converged_ticks = 20;         ///< for which they must
  double validity_min = 0.5;        ///< of the estimate
  double model_uncertainty = 0.2;   ///< relative, of the stored model's parameters
  double error_sigmas = 2.0;        ///< standard errors of the estimate that new gains must survive
  int gain_lead_ticks = 2;          ///< from the issue of gains to the tick from which they act
  int refractory_ticks = 100;       ///< from one issue of a slot's gains to the next
};

/// The sections of a robot file, and where they stand; an empty place: not in the file.
struct EstimatorSection {
  EstimatorParams params;
  config::Place place;
};
struct UpdateLogicSection {
  UpdateLogicParams params;
  config::Place place;
};

/// Name of the estimator of joints that name none. When no section has it, it has the defaults, and blanks as long as
/// touchdowns jitter.
inline constexpr const char* kDefaultEstimator = "default";

void declare(config::Visitor& v, EstimatorSection& estimator);
void declare(config::Visitor& v, UpdateLogicSection& logic);

}  // namespace farrier::robot
