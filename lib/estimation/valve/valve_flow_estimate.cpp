// The estimate of a valve's flow from what its regression has learnt.

#include <algorithm>
#include <cmath>

#include "control/model/discretise.hpp"
#include "estimation/joint_estimator.hpp"
#include "estimation/valve/valve_flow_estimator.hpp"
#include "plant/linear_model.hpp"

namespace farrier::estimation {
namespace {

// Least residual variance of standard errors: errors of the model are no noise.
constexpr double kLeastVariance = 0.1;
// A gain of more than this share of the nominal one is no valve's.
constexpr double kLargestGain = 5.0;
// A leakage or an overlap below zero by more standard errors than these, and by more than the share, is no valve's.
constexpr double kNegativeSigmas = 3.0, kNegativeShare = 0.02;
// Samples after a change of the valve before the oil's compressibility follows again. Oil does not change with a valve,
// and a loop that oscillates compresses it.
constexpr std::int64_t kOilSamples = 2500;
// The largest compressibility over the nominal one that is given on. Oil that is softer has so much air that no law helps.
constexpr double kLargestCompressibility = 5.0;

// The positive part of the estimate of James and Stein (1961): an uncertain change counts as less.
double shrunk(double change, double error) noexcept {
  const double uncertain = error / std::max(std::abs(change), 1e-300);
  return change * std::max(0.0, 1.0 - uncertain * uncertain);
}

}  // namespace

ValveFlowEstimator::Parameters ValveFlowEstimator::linear_parts() const noexcept {
  return prior_ + regression_.parameters().row(0).transpose().cwiseProduct(deviation_);
}

ValveFlowEstimator::Parameters ValveFlowEstimator::parameters() const noexcept {
  Parameters all = linear_parts();
  all(kOverlapPart) /= std::max(all(kGainPart), kLeastGain);
  return all;
}

// Smoothed samples are correlated over twice the filter's time constant.
ValveFlowEstimator::Parameters ValveFlowEstimator::standard_errors() const noexcept {
  const double variance =
      std::max(regression_.residual_variance()(0), kLeastVariance) * 2.0 * own_.smoothing_s / scales_.period_s;
  const Rls<kParameters>::Covariance covariance = regression_.covariance();
  Parameters errors;
  for (int i = 0; i < kParameters; ++i) {
    errors(i) = deviation_(i) * std::sqrt(std::min(1.0, variance * covariance(i, i)));
  }
  errors(kOverlapPart) /= std::max(parameters()(kGainPart), kLeastGain);
  return errors;
}

double ValveFlowEstimator::compressibility() const noexcept {
  if (regression_.samples() <= kOilSamples) {
    return held_compressibility_;
  }
  // A law for softer oil than there is may be unstable, one for stiffer oil is slow: only softer oil has to be certain.
  const double found = parameters()(kCompressibilityPart);
  const double change = found < 0.0 ? found : shrunk(found, standard_errors()(kCompressibilityPart));
  return std::clamp(1.0 + change, kLeastCompressibility, kLargestCompressibility);
}

ModelEstimate ValveFlowEstimator::estimate() const noexcept {
  ModelEstimate out;
  out.phase = phase_;
  out.flags = sample_flags_;
  out.samples = static_cast<std::uint32_t>(std::min<std::int64_t>(regression_.samples(), UINT32_MAX));
  if (regression_.samples() < params_.min_samples) {
    out.flags |= bit(EstimateFlag::kNotYetSet) | (stronger_ ? bit(EstimateFlag::kCountsAsStronger) : 0u);
  }
  const Parameters found = parameters();
  const Parameters errors = standard_errors();
  const bool negative = std::ranges::any_of(std::array<int, 2>{kOverlapPart, kLeakagePart}, [&](int i) {
    return found(i) < -std::max(kNegativeSigmas * errors(i), kNegativeShare);
  });
  if (!(found(kGainPart) >= kLeastGain && found(kGainPart) <= kLargestGain) || negative) {
    out.flags |= bit(EstimateFlag::kNotPhysical);
  }
  out.prediction_error = std::sqrt(errors_.variance());
  out.whiteness = errors_.whiteness();
  if (out.prediction_error > kMisfitFree) {
    out.flags |= bit(EstimateFlag::kMisfit);
  }
  const plant::LoadParams& load = loads_[static_cast<std::size_t>(phase_)];
  plant::ActuatorParams actuator = actuator_;
  actuator.valve_gain *= std::clamp(found(kGainPart), kLeastGain, kLargestGain);
  const double compressibility = this->compressibility();
  actuator.bulk_modulus_Pa /= compressibility;
  const plant::OperatingPoint home{.position = scales_.home_position, .valve_sign = 1.0};
  const plant::LinearModel model = plant::linearise_load_cell_force(actuator, load, home);
  const control::DiscreteModel sampled = control::discretise(model.a, model.b, scales_.period_s);
  out.a = sampled.a;
  out.b = sampled.b;
  const double gain_error = errors(kGainPart) / std::max(found(kGainPart), kLeastGain);
  out.b_error = gain_error * out.b.cwiseAbs();
  const std::uint32_t forbidding = bit(EstimateFlag::kNotPhysical) | bit(EstimateFlag::kNotYetSet);
  const bool usable = (out.flags & forbidding) == 0 && out.a.allFinite() && out.b.allFinite();
  out.validity = usable ? std::clamp(1.0 - gain_error / kUselessGainError, 0.0, 1.0) : 0.0;
  out.excitation = 1.0 / regression_.covariance_trace();

  out.has_physics = true;
  out.physics = plant::nominal_physics(actuator, load);
  const double per_leakage = open_flow_m3_s_ / actuator_.supply_pressure_Pa;
  out.physics.leakage = std::max(0.0, found(kLeakagePart)) * per_leakage;
  out.physics.overlap_A = std::max(0.0, found(kOverlapPart)) * actuator_.valve_current_max_A;
  out.physics_error.valve_gain = errors(kGainPart) * actuator_.valve_gain;
  out.physics_error.bulk_modulus = errors(kCompressibilityPart) / compressibility * actuator.bulk_modulus_Pa;
  out.physics_error.leakage = errors(kLeakagePart) * per_leakage;
  out.physics_error.overlap_A = errors(kOverlapPart) * actuator_.valve_current_max_A;
  return out;
}

}  // namespace farrier::estimation
