#pragma once

// One joint's physics and the linear model that follows from it:
//
//   x, v, F_s, i_v ──▶ GreyBoxFilter with the load of the phase ──▶ physics ──▶ linearise, sample ──▶ estimate()

#include <Eigen/Core>

#include <array>
#include <cstdint>

#include "core/result.hpp"
#include "estimation/estimator.hpp"
#include "estimation/estimator_params.hpp"
#include "estimation/grey_box_filter.hpp"

namespace farrier::estimation {

/// Effects of an actuator that are known beside its parameters.
struct KnownActuator {
  double leakage = 0.0;        ///< between its chambers, m^3/s/Pa; >= 0
  double seal_friction = 0.0;  ///< of its piston, left of the load cell, N or Nm; >= 0
  double overlap_A = 0.0;      ///< of its valve, which the estimator does not use; >= 0
};

/// Estimates the unknown physics of a hydraulic joint with the joint's own nonlinear equations. Large motion is
/// therefore as informative as small motion, and the joint need not be excited at its resonance (Hubacher 2014, 9.1.5,
/// 10.3 ask for such an estimator). The filter and its limits of identifiability: docs/derivations/grey-box.md.
///
/// The model is linearised at home with the valve just opening to extend, as robot::model_of is: gains designed from it
/// do not chase the operating point. Its standard errors and validity follow from the covariance of the unknowns. c is
/// 0: a bias force is in the physics.
class GreyBoxEstimator final : public Estimator {
 public:
  /// Uses grey_box (absent: its defaults), blank_ticks, min_samples and phase_memory of `params`; a gate is refused.
  /// The `actuator` is the nominal one, with what else is `known` of it. The `prior` is the load of either phase before
  /// any measurement; a change of load begins at the geometric mean of both. Refuses settings out of range, actuators and loads that no machine has,
  /// and loads without mass, naming each.
  static Result<GreyBoxEstimator> create(const EstimatorParams& params, const JointScales& scales,
                                         const plant::ActuatorParams& actuator,
                                         const std::array<plant::LoadParams, 2>& prior,
                                         const KnownActuator& known = {});

  /// Takes one tick. After a gap the filter restarts at the measurement; the estimate of the joint stays.
  void take(const JointSample& sample) noexcept override;

  /// Estimate for the phase of the last sample.
  ModelEstimate estimate() const noexcept override;

  std::unique_ptr<Estimator> clone() const override { return std::make_unique<GreyBoxEstimator>(*this); }

 private:
  struct PhaseMemory {
    GreyBoxFilter::Load load;
    std::uint32_t samples = 0;
  };

  GreyBoxEstimator(const EstimatorParams& params, const JointScales& scales, const GreyBoxModel& model,
                   const GreyBoxFilter& filter, const std::array<GreyBoxFilter::Load, 2>& loads) noexcept;

  void change_phase(int phase) noexcept;
  void linearise(const Unknowns& unknowns, Eigen::Matrix3d& a, Eigen::Vector3d& b) const noexcept;

  EstimatorParams params_;
  JointScales scales_;
  GreyBoxModel model_;
  GreyBoxFilter filter_;
  std::array<PhaseMemory, 2> memories_;
  std::array<double, 3> currents_{};  // newest first
  int currents_known_ = 0;
  Tick last_tick_ = kNoTick;
  int phase_ = 0;
  int ticks_in_phase_ = 0;
  std::uint32_t samples_ = 0;  // since the start or the last change of load
  double misfit_ = 1.0;        // surprise over its expectation, over kMisfitMemory
  std::uint32_t sample_flags_ = 0;
};

}  // namespace farrier::estimation
