#pragma once

#include <array>

#include <Eigen/Core>

#include "control/model/discretise.hpp"
#include "control/numerics/spectrum.hpp"
#include "core/result.hpp"

namespace farrier::control {

/// Longest sampling time of a design.
inline constexpr double kMaxPeriodS = 0.1;

/// Divisors that bring states and input into [-1, 1]: T = W = diag(position, velocity, force) (3.52), V = current
/// (3.53). All positive and finite.
struct Normalisation {
  double position;   ///< m; half the stroke
  double velocity;   ///< m/s
  double force;      ///< N
  double current_A;  ///< A; also the limit of the valve current
};

/// States that the controller uses (9.2.4).
enum class Form {
  kFullState,  ///< position, velocity, force and integral; needs a load spring
  kCompliant,  ///< designed without the position state: its gain is zero, a leg stays free to move
};

/// Weights of (7.9)-(7.11) on normalised states, in the order of (7.7) and (7.8).
struct LqrWeights {
  double integral = 2.5;             ///< on the summed force error, >= 0
  double position = 1.0;             ///< >= 0; unused by the compliant form
  double velocity = 1.0;             ///< >= 0
  double force = 5000.0;             ///< >= 0
  double input = 0.1;                ///< R, > 0
  double integral_factor = 6.0;      ///< xi, multiplies the integral gain at run time; in (0, 50]
  double feed_forward_factor = 1.0;  ///< multiplies the feed-forward; in [0, 2], 0 switches it off
};

inline constexpr int kMaxDelayTicks = 2;

/// One controller of Fig. 7.1, with the model it was designed for. All gains act on normalised signals:
/// current / V = position (0 - x) + velocity (0 - v) + force (F_ref - F) + integral xi sum(F_ref - F)
///             + feed_forward F_ref - delay[0] u[k-1] - delay[1] u[k-2].
struct Gains {
  double position;
  double velocity;
  double force;
  double integral;                           ///< without xi; positive where the thesis's K_I of (7.8) is negative
  double feed_forward;                       ///< Gamma
  std::array<double, kMaxDelayTicks> delay;  ///< on the two last currents; zero beyond delay_ticks
  int delay_ticks;                           ///< loop delay of the design
  Form form;
  double integral_factor;  ///< xi
  Normalisation normalisation;
  DiscreteModel model;     ///< SI
  double spectral_radius;  ///< of the closed loop of that model, with that delay and xi
};

/// Outcome of a design: the flags of Table F.2 that concern it, and those a delay and pole placement add.
enum class DesignStatus {
  kSuccessful,
  kModelNotFinite,
  kWrongSamplingTime,
  kNormalisationOutOfBounds,
  kIntegralFactorOutOfBounds,
  kWrongOptionForFeedForward,
  kDelayOutOfBounds,
  kWeightsNotPositiveDefinite,
  kNotStabilisable,
  kNotControllable,   ///< pole placement: a mode the input cannot move
  kPolesOutOfBounds,  ///< pole placement: bandwidth or damping
  kPolesNotPlaced,    ///< pole placement: rounding left the poles elsewhere
  kRiccatiNotConverging,
  kClosedLoopNotStable,
};

const char* to_string(DesignStatus status) noexcept;

/// Designs the LQR of Chapter 7 for a sampled model: normalises it, adds the force integrator (7.7) and, for a loop
/// with delay, the last inputs as states. Then it solves (7.4) with N = 0 and checks the closed loop with xi inside.
///
/// The feed-forward makes the gain from reference to force one without the integrator ("N-bar" of Franklin, Powell and
/// Workman 1998, section 8.4.2). The full-state form computes it at rest. A load without a spring never rests under a
/// force: it slides off at F / d_l, and the static gain grows with 1 / d_l. The compliant form therefore uses the real
/// part at 0.0314 rad per period, 5 Hz at 1 kHz, in the middle of a trot's spectrum; that is finite at any damping.
///
/// delay_ticks in 0..2. Every refusal has its own name; kSuccessful is never one. `poles`, if not null, receives
/// closed_loop_spectrum() of the model with the gains, which margins() takes.
Result<Gains, DesignStatus> design_lqr(const DiscreteModel& model, const LqrWeights& weights,
                                       const Normalisation& normalisation, Form form, int delay_ticks,
                                       SmallSpectrum* poles = nullptr) noexcept;

/// Same, from a continuous model (SI) and a period in (0, 0.1] s.
Result<Gains, DesignStatus> design_lqr(const Eigen::Matrix3d& a, const Eigen::Vector3d& b, double period_s,
                                       const LqrWeights& weights, const Normalisation& normalisation, Form form,
                                       int delay_ticks) noexcept;

/// The model in normalised units: T^-1 a T, T^-1 b V.
DiscreteModel normalise(const DiscreteModel& model, const Normalisation& normalisation) noexcept;

}  // namespace farrier::control
