#include "estimation/grey_box_estimator.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "control/model/discretise.hpp"
#include "core/ticks_since.hpp"
#include "estimation/joint_estimator.hpp"
#include "estimation/poles.hpp"
#include "plant/linear_model.hpp"

namespace farrier::estimation {
namespace {

// Sensors are never taken for better than these shares of their scales: the tick is integrated to about as much.
const Eigen::Vector3d kBestSensors(2.5e-5, 5e-4, 2e-4);
// Coulomb friction turns over within this share of the velocity's scale.
constexpr double kSlip = 0.004;
// On end stops and voids: what a tick may do to velocity and to pressure, shares of scale and supply.
constexpr double kBentVelocity = 0.04;
constexpr double kBentPressure = 0.02;
constexpr double kMisfitMemory = 0.98;  // 50 ticks
constexpr double kExpectedSurprise = 3.0;
constexpr double kMostMisfit = 100.0;  // of one tick: an outlier alone is no misfit

double squared(double x) noexcept { return x * x; }

/// Names what of the settings is out of range; empty when nothing is.
std::string out_of_range(const GreyBoxParams& p) {
  std::string text;
  const auto within = [&text](const char* name, double value, double low, double high) {
    if (!(value >= low && value <= high)) {
      text += std::string(text.empty() ? "" : "; ") + name + " must be within [" + std::to_string(low) + ", " +
              std::to_string(high) + "], is " + std::to_string(value);
    }
  };
  within("mass_uncertainty", p.mass_uncertainty, 1e-3, 5.0);
  within("damping_uncertainty", p.damping_uncertainty, 0.0, 5.0);
  within("coulomb_uncertainty", p.coulomb_uncertainty, 0.0, 1.0);
  within("stiffness_uncertainty", p.stiffness_uncertainty, 0.0, 10.0);
  within("bias_uncertainty", p.bias_uncertainty, 0.0, 1.0);
  within("valve_gain_uncertainty", p.valve_gain_uncertainty, 0.0, 2.0);
  within("bulk_modulus_uncertainty", p.bulk_modulus_uncertainty, 0.0, 2.0);
  within("leakage_uncertainty", p.leakage_uncertainty, 0.0, 1.0);
  within("load_drift", p.load_drift, 0.0, 100.0);
  within("bias_drift", p.bias_drift, 0.0, 100.0);
  within("flow_error", p.flow_error, 0.0, 1.0);
  within("force_error", p.force_error, 0.0, 1.0);
  within("change_threshold", p.change_threshold, 5.0, 1e12);
  return text;
}

GreyBoxNoise noise_of(const GreyBoxParams& p, const JointScales& s, const plant::ActuatorParams& act) noexcept {
  GreyBoxNoise noise;
  noise.sensor_variance = s.sensor_noise.cwiseMax(kBestSensors.cwiseProduct(s.state)).array().square();
  noise.force_variance = squared(p.force_error * s.state(2));
  noise.flow_error = p.flow_error;
  noise.drift_variance(kMass) = squared(p.load_drift) * s.period_s;
  noise.drift_variance(kDamping) = p.damping_uncertainty > 0.0 ? squared(p.load_drift) * s.period_s : 0.0;
  noise.drift_variance(kBias) = squared(p.bias_drift * s.state(2)) * s.period_s;
  noise.bent_velocity_variance = squared(kBentVelocity * s.state(1));
  noise.bent_pressure_variance = squared(kBentPressure * act.supply_pressure_Pa);
  return noise;
}

Unknowns variance_of(const GreyBoxParams& p, const JointScales& s, const plant::ActuatorParams& act,
                     double stiffness) noexcept {
  const double open_flow = act.valve_gain * act.valve_current_max_A * std::sqrt(act.supply_pressure_Pa);
  Unknowns v;
  v << p.mass_uncertainty, p.damping_uncertainty, p.coulomb_uncertainty * s.state(2),
      p.stiffness_uncertainty * stiffness, p.bias_uncertainty * s.state(2), p.valve_gain_uncertainty,
      p.bulk_modulus_uncertainty, p.leakage_uncertainty * open_flow / act.supply_pressure_Pa;
  return v.array().square();
}

}  // namespace

Result<GreyBoxEstimator> GreyBoxEstimator::create(const EstimatorParams& shared, const JointScales& scales,
                                                  const plant::ActuatorParams& actuator,
                                                  const std::array<plant::LoadParams, 2>& prior,
                                                  const KnownActuator& known) {
  const GreyBoxParams params = shared.grey_box.value_or(GreyBoxParams{});
  if (const std::string wrong = out_of_range(params); !wrong.empty()) {
    return Error{"grey_box: " + wrong};
  }
  if (shared.blank_ticks < 0 || shared.min_samples < 1) {
    return Error{"blank_ticks must not be negative, min_samples at least 1"};
  }
  if (shared.gate != GateKind::kNone) {
    return Error{"a gate chooses what a regression learns from: greybox needs gate: none"};
  }
  FARRIER_TRY(validate(scales));
  FARRIER_TRY(plant::validate(actuator));
  for (const plant::LoadParams& load : prior) {
    FARRIER_TRY(plant::validate(load));
    if (!(load.mass > 0.0)) {
      return Error{"grey_box: both prior loads need a mass above 0 kg, for its logarithm is estimated"};
    }
  }
  if (prior[0].equilibrium_position != prior[1].equilibrium_position) {
    return Error{"grey_box: both prior loads must have one equilibrium_position, which is not estimated"};
  }
  const GreyBoxModel model(actuator, prior[0].equilibrium_position, kSlip * scales.state(1), known.seal_friction);
  std::array<GreyBoxFilter::Load, 2> loads;
  std::array<Unknowns, 2> first;
  for (std::size_t i = 0; i < 2; ++i) {
    plant::JointPhysics physics = plant::nominal_physics(actuator, prior[i]);
    physics.leakage = known.leakage;
    first[i] = model.unknowns_of(physics);
    loads[i].unknowns = first[i].head<5>();
    loads[i].covariance = variance_of(params, scales, actuator, prior[i].stiffness).head<5>().asDiagonal();
  }
  const GreyBoxRestart restart{.unknowns = 0.5 * (first[0] + first[1]),
                               .mass_variance = squared(params.mass_uncertainty),
                               .damping_variance = squared(params.damping_uncertainty),
                               .threshold = params.change_threshold};
  const GreyBoxFilter filter(model, noise_of(params, scales, actuator), restart, first[0],
                             variance_of(params, scales, actuator, prior[0].stiffness), scales.period_s);
  return GreyBoxEstimator(shared, scales, model, filter, loads);
}

GreyBoxEstimator::GreyBoxEstimator(const EstimatorParams& params, const JointScales& scales, const GreyBoxModel& model,
                                   const GreyBoxFilter& filter,
                                   const std::array<GreyBoxFilter::Load, 2>& loads) noexcept
    : params_(params), scales_(scales), model_(model), filter_(filter), memories_{{{loads[0]}, {loads[1]}}} {}

void GreyBoxEstimator::change_phase(int phase) noexcept {
  ticks_in_phase_ = 0;
  if (params_.phase_memory) {
    memories_[static_cast<std::size_t>(phase_)] = {filter_.load(), samples_};
    const PhaseMemory& known = memories_[static_cast<std::size_t>(phase)];
    filter_.set_load(known.load);
    samples_ = known.samples;
  }
  phase_ = phase;
}

void GreyBoxEstimator::take(const JointSample& sample) noexcept {
  const bool sound = (sample.state.cwiseQuotient(scales_.state).array().abs() <= kLargestSignal).all() &&
                     std::abs(sample.current_A / scales_.current_A) <= kLargestSignal && sample.phase >= 0 &&
                     sample.phase <= 1;
  if (!sound) {
    sample_flags_ = (sample_flags_ & bit(EstimateFlag::kBlanked)) | bit(EstimateFlag::kSampleRefused);
    return;
  }
  const bool first = last_tick_ == kNoTick;
  const bool follows = !first && ticks_since(last_tick_, sample.tick) == 1;
  if (sample.phase != phase_) {
    change_phase(sample.phase);
    if (first) {
      ticks_in_phase_ = params_.blank_ticks;  // not a switch: the first sample says where the leg is
    }
  } else if (first) {
    ticks_in_phase_ = params_.blank_ticks;
  } else {
    ticks_in_phase_ = std::min(ticks_in_phase_ + 1, params_.blank_ticks);
  }
  last_tick_ = sample.tick;
  const bool blanked = ticks_in_phase_ < params_.blank_ticks;
  sample_flags_ = blanked ? bit(EstimateFlag::kBlanked) : 0;
  if (!follows || currents_known_ <= scales_.input_delay_ticks) {
    currents_known_ = follows ? currents_known_ : 0;
    filter_.anchor(sample.state);
  } else {
    const double acted = currents_[static_cast<std::size_t>(scales_.input_delay_ticks)];
    switch (filter_.step(sample.state, acted, !blanked)) {
      case GreyBoxFilter::Outcome::kTaken:
        samples_ += blanked ? 0 : 1;
        break;
      case GreyBoxFilter::Outcome::kChanged:
        samples_ = 0;
        break;
      case GreyBoxFilter::Outcome::kRepaired:
        samples_ = 0;
        sample_flags_ |= bit(EstimateFlag::kCovarianceRepaired);
        break;
    }
    if (!blanked) {
      const double surprise = filter_.surprise() / kExpectedSurprise;
      misfit_ = kMisfitMemory * misfit_ + (1.0 - kMisfitMemory) * (surprise < kMostMisfit ? surprise : kMostMisfit);
    }
  }
  currents_ = {sample.current_A, currents_[0], currents_[1]};
  currents_known_ = std::min(currents_known_ + 1, 3);
}

void GreyBoxEstimator::linearise(const Unknowns& unknowns, Eigen::Matrix3d& a, Eigen::Vector3d& b) const noexcept {
  const plant::JointPhysics physics = model_.physics_of(unknowns);
  plant::ActuatorParams actuator = model_.actuator();
  actuator.valve_gain = physics.valve_gain;
  actuator.bulk_modulus_Pa = physics.bulk_modulus;
  const plant::LoadParams load{.mass = physics.load_mass,
                               .damping = physics.damping,
                               .stiffness = std::max(physics.stiffness, 0.0),
                               .equilibrium_position = model_.equilibrium_position()};
  const plant::OperatingPoint home{.position = scales_.home_position, .valve_sign = 1.0};
  const plant::LinearModel model = plant::linearise_load_cell_force(actuator, load, home);
  const control::DiscreteModel sampled = control::discretise(model.a, model.b, scales_.period_s);
  a = sampled.a;
  b = sampled.b;
}

ModelEstimate GreyBoxEstimator::estimate() const noexcept {
  ModelEstimate out;
  out.phase = phase_;
  out.samples = samples_;
  out.flags = sample_flags_;
  if (samples_ < static_cast<std::uint32_t>(params_.min_samples)) {
    out.flags |= bit(EstimateFlag::kNotYetSet);
  }
  if (misfit_ > kMisfitFree * kMisfitFree) {
    out.flags |= bit(EstimateFlag::kMisfit);
  }
  const Unknowns& unknowns = filter_.unknowns();
  linearise(unknowns, out.a, out.b);
  const Poles<3> z = poles<3>(out.a);

  // Sigma points along the columns of the covariance's Cholesky factor L: sum of squares of what each moves.
  const Eigen::Matrix<double, kUnknowns, kUnknowns> covariance = filter_.covariance();
  Eigen::Matrix<double, kUnknowns, kUnknowns> factor = Eigen::Matrix<double, kUnknowns, kUnknowns>::Zero();
  double pole_variance = 0.0;
  for (int j = 0; j < kUnknowns; ++j) {
    const double pivot = covariance(j, j) - factor.row(j).head(j).squaredNorm();
    if (!(pivot > 1e-14 * covariance(j, j))) {
      continue;
    }
    factor(j, j) = std::sqrt(pivot);
    for (int i = j + 1; i < kUnknowns; ++i) {
      factor(i, j) = (covariance(i, j) - factor.row(i).head(j).dot(factor.row(j).head(j))) / factor(j, j);
    }
    Eigen::Matrix3d a;
    Eigen::Vector3d b;
    linearise(unknowns + factor.col(j), a, b);
    out.a_error.array() += (a - out.a).array().square();
    out.b_error.array() += (b - out.b).array().square();
    pole_variance += squared(pole_distance<3>(z, poles<3>(a)));
  }
  out.a_error = out.a_error.cwiseSqrt();
  out.b_error = out.b_error.cwiseSqrt();
  const bool usable_model =
      out.a.allFinite() && out.b.allFinite() && out.flags == (out.flags & bit(EstimateFlag::kBlanked));
  out.validity = usable_model ? std::max(0.0, 1.0 - std::sqrt(pole_variance) / kUselessPoleError) : 0.0;
  const double load_variance = covariance(kMass, kMass) + covariance(kDamping, kDamping);
  out.excitation = load_variance > 0.0 ? 1.0 / load_variance : 0.0;

  out.has_physics = true;
  out.physics = model_.physics_of(unknowns);
  const Unknowns sigma = covariance.diagonal().cwiseSqrt();
  out.physics_error = {.load_mass = out.physics.load_mass * sigma(kMass),
                       .damping = out.physics.damping * sigma(kDamping),
                       .coulomb = sigma(kCoulomb),
                       .stiffness = sigma(kStiffness),
                       .bias_force = sigma(kBias),
                       .valve_gain = out.physics.valve_gain * sigma(kValveGain),
                       .bulk_modulus = out.physics.bulk_modulus * sigma(kBulkModulus),
                       .leakage = sigma(kLeakage)};
  return out;
}

}  // namespace farrier::estimation
