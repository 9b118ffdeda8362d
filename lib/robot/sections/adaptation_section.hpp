#pragma once

#include "config/visitor.hpp"
#include "estimation/estimator_params.hpp"

namespace farrier::robot {

using estimation::EstimatorParams;

/// Condition under which an estimate leads to new gains: (a) to (d) of Hubacher (2014), Section 5.3.1, in that order.
enum class UpdateMethod {
  kLimits,         ///< new gains are bounded and change slowly from one estimate to the next
  kSmallError,     ///< the estimate predicts well
  kWhiteError,     ///< and its errors are white
  kDistinctPoles,  ///< it differs distinctly from the model of the acting gains, and has converged
};

/// As in a robot file.
const char* to_string(UpdateMethod method) noexcept;

/// Conditions for new gains from an estimate (Hubacher 2014, 8.2.1, Fig. 8.8), and bounds that new gains must hold.
struct UpdateLogicParams {
  UpdateMethod method = UpdateMethod::kDistinctPoles;
  double pole_distance_min = 0.1;   ///< to the poles the acting gains are designed for, z-plane
  double gain_ratio_min = 1.2;      ///< of the valve's gain to the one they are designed for, or its inverse; > 1
  double pole_spread_max = 0.05;    ///< of the poles that count as converged, z-plane
  int converged_ticks = 20;         ///< for which these poles, or another method's condition, must hold
  double prediction_error_max = 100;  ///< small_error, white_error: of the estimate
  double whiteness_min = 1e-24;    ///< white_error: of its errors
  double state_gain_max = 20.0;     ///< limits: norm of the normalised gains on position, velocity and force
  double integral_gain_max = 1.0;   ///< limits: normalised, without xi
  double feed_forward_max = 50.0;   ///< limits: normalised
  double state_gain_rate_max_1_s = 10.0;    ///< limits: relative change from one estimate to the next, over its time
  double integral_gain_rate_max_1_s = 10.0; ///< limits
  double feed_forward_rate_max_1_s = 10.0;  ///< limits
  double validity_min = 0.8;        ///< of the estimate
  double model_uncertainty = 0.3;   ///< relative, of the stored model's parameters, when it was stored
  double uncertainty_growth_1_s = 10.0;  ///< by which that grows while valid, converged estimates speak against it
  double error_sigmas = 2.0;        ///< standard errors of the valve's gain that new gains must survive
  double disk_margin_min = 0.05;    ///< of new gains around the model they are for, balanced, 0..2
  double delay_margin_min_s = 0.0;  ///< delay they must tolerate beyond the loop's own
  double physics_change_min = 0.03; ///< relative, of any of a joint's physics, for controllers that invert the flow law
  int gain_lead_ticks = 2;          ///< from the issue of gains to the tick from which they act
};

/// The sections of a robot file, with their places; an empty place: not in the file.
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
