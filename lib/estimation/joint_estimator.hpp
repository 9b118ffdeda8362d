#pragma once

// One joint's estimator, from sensors to a model:
//
//   x, v, F, u ──▶ normalise ──▶ Washout ──▶ regressor of the tick before ──▶ regression of the phase ──▶ estimate()
//                                    ├──▶ state filter: prediction against sensors ──▲ ▲
//                                    └──▶ ExcitationGate: may this tick teach? ──────────┘

#include <Eigen/Core>

#include <array>
#include <cstdint>

#include "core/result.hpp"
#include "estimation/estimator.hpp"
#include "estimation/estimator_params.hpp"
#include "estimation/excitation_gate.hpp"
#include "estimation/linear_regression.hpp"
#include "estimation/prediction_errors.hpp"
#include "estimation/stable_map.hpp"
#include "estimation/washout.hpp"

namespace farrier::estimation {

/// Standard error of a pole, in the z-plane, at which an estimate has no value any more.
inline constexpr double kUselessPoleError = 0.6;

/// Misfit is the prediction error of ModelEstimate. A joint that oscillates between the valve's limits responds less
/// than the model's valve gain near rest. Least squares then returns the gain of the oscillation, with a small error,
/// and gains designed for it sustain the oscillation. Beyond kMisfitFree the relative error of the valve's gain grows
/// by kMisfitError for every further unit.
inline constexpr double kMisfitFree = 3.0;
inline constexpr double kMisfitError = 0.05;

/// Recursive regression of a joint whose load changes with the phase of its leg (Hubacher 2014, 6.2, 8.1), by the method
/// the parameters name; docs/estimators.md compares them.
///
/// The first row is known and not estimated: position is summed velocity. Measured states are noisy regressors, which
/// biases least squares (Soderstrom 2007, "Errors-in-variables methods in system identification"), and here the loop
/// feeds the noise back into the input. So the regressor holds states corrected towards their prediction. The
/// correction of a channel is 1 - (sensor variance) / (prediction error variance), the gain of a scalar Kalman filter
/// with measured innovation variance. A model that predicts well is trusted; one that does not leaves the sensors
/// unchanged. With instruments the regressor is the sensors' and the instrument is the model's own simulation, which
/// replaces the filter.
class JointEstimator final : public Estimator {
 public:
  /// `prior_a`, `prior_b`: SI, where both phases start. Refuses settings out of range, naming them.
  static Result<JointEstimator> create(const EstimatorParams& params, const JointScales& scales,
                                       const Eigen::Matrix3d& prior_a, const Eigen::Vector3d& prior_b);

  /// Takes one tick. A step of more than three ticks from the last sample restarts the filters; samples that are not
  /// finite count as missing. No samples are used until the filters have settled. Estimates stay.
  void take(const JointSample& sample) noexcept override;

  /// Estimate for the phase of the last sample.
  ModelEstimate estimate() const noexcept override;

  std::unique_ptr<Estimator> clone() const override { return std::make_unique<JointEstimator>(*this); }

  /// Forgetting between the last sample of `phase`, 0 or 1, and the next one: lambda of the rows of position, velocity
  /// and force, Fig. 9.3.
  Eigen::Vector3d forgetting(int phase) const noexcept;

 private:
  struct PhaseMemory {
    LinearRegression regression;
    Eigen::Vector3d innovation_variance;
    PredictionErrors force_errors;
  };

  JointEstimator(const EstimatorParams& params, const JointScales& scales, PhaseMemory memory, ExcitationGate gate);

  PhaseMemory& memory(int phase) noexcept { return memories_[params_.phase_memory ? static_cast<std::size_t>(phase) : 0]; }
  const PhaseMemory& memory(int phase) const noexcept {
    return memories_[params_.phase_memory ? static_cast<std::size_t>(phase) : 0];
  }
  void restart(const Eigen::Vector4d& washed) noexcept;
  void interrupt_errors() noexcept;
  template <class Engine>
  void update(Engine& engine, PhaseMemory& known, const Eigen::Vector3d& measured) noexcept;
  template <class Engine>
  void read(const Engine& engine, const PredictionErrors& force_errors, ModelEstimate& out) const noexcept;

  EstimatorParams params_;
  JointScales scales_;
  Eigen::Vector3d noise_variance_;  // normalised
  double kinematic_step_;           // normalised velocity to normalised position over a period
  Washout washout_;
  int settling_ticks_;              // until the washout has forgotten its start
  ExcitationGate gate_;
  std::array<PhaseMemory, 2> memories_;
  Eigen::Vector3d filtered_ = Eigen::Vector3d::Zero();  // state of the last tick
  Eigen::Vector3d simulated_ = Eigen::Vector3d::Zero();  // the same by the model's simulation, without sensors
  std::array<double, 3> inputs_{};                      // washed-out, newest first
  int inputs_known_ = 0;
  int unsettled_ticks_ = 0;
  Tick last_tick_ = kNoTick;
  int phase_ = -1;
  int ticks_in_phase_ = 0;
  std::uint32_t sample_flags_ = 0;
};

}  // namespace farrier::estimation
