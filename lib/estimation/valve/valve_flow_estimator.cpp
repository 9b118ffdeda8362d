#include "estimation/valve/valve_flow_estimator.hpp"

#include <algorithm>
#include <cmath>

#include "core/portable_math.hpp"
#include "core/ticks_since.hpp"
#include "estimation/joint_estimator.hpp"
#include "estimation/valve/valve_flow_check.hpp"
#include "plant/load_pressure.hpp"

namespace farrier::estimation {
namespace {

constexpr int kFlow = 0, kParts = 1, kCompression = 6, kSupply = 7;  // of the terms
// Least residual variance for the detection of changes: a little noise is no change of a valve that had none.
constexpr double kLeastResidual = 0.02;
// Error of the supply's pressure, share: the flow goes with the root of a drop that it is part of.
constexpr double kSupplyError = 0.1, kMeasuredSupplyError = 0.03;  // the measured one is at most 10 ms old
// A supply sensor that reads more than this share of the nominal pressure is broken: the relief valve opens before.
constexpr double kLargestSupply = 1.5;
// Limit of the covariance's trace over that at the start: without excitation an estimate stays as certain as at first.
constexpr double kCovarianceLimit = 1.01;
// After an alarm nothing is learnt for so long: the oscillation dies out, and the supply recovers from what it drew.
constexpr double kCalm_s = 0.15;
// The calmer law is there within 20 ms and needs a few cycles.
constexpr double kDeaf_s = 0.06;
// Factor on the variances of damping and oil at a change of the valve: what passes in the change is not all the valve's.
constexpr double kLessSure = 4.0;
// A valve whose gain is within this share of what it was at the last alarm has not changed. The oil is then stiffer, by this factor.
constexpr double kSameValve = 0.15, kStiffer = 1.5;
// A loop that oscillates with gains for a valve of this share has another cause.
constexpr double kStrongest = 2.5;

}  // namespace

Result<ValveFlowEstimator> ValveFlowEstimator::create(const EstimatorParams& params, const JointScales& scales,
                                                      const plant::ActuatorParams& actuator,
                                                      const std::array<plant::LoadParams, 2>& loads,
                                                      const KnownValve& known) {
  const ValveFlowParams own = params.valve_flow.value_or(ValveFlowParams{});
  FARRIER_TRY(validate(own));
  if (params.gate != GateKind::kNone) {
    return Error{"a gate chooses what a regression on states learns from: valve_flow needs gate: none"};
  }
  FARRIER_TRY(validate(scales));
  FARRIER_TRY(plant::validate(actuator));
  for (const plant::LoadParams& load : loads) {
    FARRIER_TRY(plant::validate(load));
  }
  const RlsParams rls{.forgetting_factor = portable::exp(-scales.period_s / own.memory_s),
                      .initial_covariance = 1.0,
                      .covariance_limit = kCovarianceLimit * kParameters};
  const auto regression = FARRIER_TRY(Rls<kParameters>::create(rls));
  return ValveFlowEstimator(params, own, scales, actuator, loads, known, regression);
}

ValveFlowEstimator::ValveFlowEstimator(const EstimatorParams& params, const ValveFlowParams& own,
                                       const JointScales& scales, const plant::ActuatorParams& actuator,
                                       const std::array<plant::LoadParams, 2>& loads, const KnownValve& known,
                                       const Rls<kParameters>& regression) noexcept
    : params_(params),
      own_(own),
      scales_(scales),
      actuator_(actuator),
      supplied_(actuator),
      supply_error_(kSupplyError),
      loads_(loads),
      open_flow_m3_s_(actuator.valve_gain * actuator.valve_current_max_A * std::sqrt(actuator.supply_pressure_Pa)),
      prior_{1.0, known.overlap_A / actuator.valve_current_max_A,
             known.leakage * actuator.supply_pressure_Pa / open_flow_m3_s_, 0.0, 0.0},
      deviation_{own.gain_uncertainty, own.overlap_uncertainty, own.leakage_uncertainty, own.damping_uncertainty,
                 own.compressibility_uncertainty},
      spool_(known.spool),
      regression_(regression),
      oil_(actuator) {}

// The state is the mean of a period's ends but for the force, which is the rate of the hydraulic one.
ValveFlowEstimator::Terms ValveFlowEstimator::terms(const Eigen::Vector3d& state, double opening_A) const noexcept {
  const Eigen::Vector3d mean = 0.5 * (state + last_state_);
  const Eigen::Vector3d change = state - last_state_;
  const double force_rate = (change(2) + actuator_.piston_damping * change(1)) / scales_.period_s;
  const plant::OperatingPoint point = point_of(mean);
  const plant::LoadPressureCoefficients rates = plant::load_pressure_coefficients(supplied_, point);
  const double compliance = -rates.K_vp / actuator_.area_a;  // rate of the load pressure per flow
  const double compression = force_rate / (actuator_.area_a * compliance);
  const double flow = actuator_.area_a * mean(1) + compression;
  const double per_opening = rates.by_current() / compliance * actuator_.valve_current_max_A;
  const double damping_Pa = actuator_.piston_damping * mean(1) / actuator_.area_a;
  Terms terms;
  terms << flow / open_flow_m3_s_, per_opening * opening_A / actuator_.valve_current_max_A / open_flow_m3_s_,
      -sign_ * per_opening / open_flow_m3_s_,
      -plant::leakage_pressure_Pa(supplied_, point) / actuator_.supply_pressure_Pa,
      -sign_ * damping_Pa / (2.0 * rates.root * rates.root) * flow / open_flow_m3_s_, -compression / open_flow_m3_s_,
      std::abs(compression) / open_flow_m3_s_,
      supply_error_ * supplied_.supply_pressure_Pa / (2.0 * rates.root * rates.root) * std::abs(flow) / open_flow_m3_s_;
  return terms;
}

void ValveFlowEstimator::take(const JointSample& sample) noexcept {
  const bool sound = (sample.state.cwiseQuotient(scales_.state).array().abs() <= kLargestSignal).all() &&
                     std::abs(sample.current_A / scales_.current_A) <= kLargestSignal && sample.phase >= 0 &&
                     sample.phase <= 1;
  if (!sound) {
    sample_flags_ = bit(EstimateFlag::kSampleRefused);
    return;
  }
  const bool follows = last_tick_ != kNoTick && ticks_since(last_tick_, sample.tick) == 1;
  last_tick_ = sample.tick;
  phase_ = sample.phase;
  sample_flags_ = 0;
  if (sample.supply_pressure_Pa > 0.0 && sample.supply_pressure_Pa <= kLargestSupply * actuator_.supply_pressure_Pa) {
    supplied_.supply_pressure_Pa = sample.supply_pressure_Pa;
    supply_error_ = kMeasuredSupplyError;
  }
  const double limit_A = actuator_.valve_current_max_A;
  if (follows && currents_known_ > scales_.input_delay_ticks) {
    const double current_A = currents_[static_cast<std::size_t>(scales_.input_delay_ticks)];
    take_opening(sample.state, spool_.move(std::clamp(current_A, -limit_A, limit_A)));
  } else {
    currents_known_ = follows ? currents_known_ : 0;
    interrupt();
    spool_.rest_at(std::clamp(sample.current_A, -limit_A, limit_A));
  }
  watch(sample);
  last_state_ = sample.state;
  currents_ = {sample.current_A, currents_[0], currents_[1]};
  currents_known_ = std::min(currents_known_ + 1, 3);
}

void ValveFlowEstimator::take_opening(const Eigen::Vector3d& state, double opening_A) noexcept {
  const double shut = own_.least_opening + std::max(0.0, parameters()(kOverlapPart));
  if (std::abs(opening_A) < shut * actuator_.valve_current_max_A) {
    interrupt();
    sample_flags_ = bit(EstimateFlag::kNotExciting);
    return;
  }
  const double sign = opening_A > 0.0 ? 1.0 : -1.0;
  if (sign != sign_) {
    oil_.interrupt();
    smoothed_ticks_ = 0.0;
  }
  sign_ = sign;
  const Terms now = terms(state, opening_A);
  const double oil_m3 = std::abs(now(kFlow)) * open_flow_m3_s_ * scales_.period_s;
  const bool steady = oil_.take(supplied_, point_of(state), oil_m3);
  if (oil_.fills()) {
    smooth(now);
  } else {
    smoothed_ticks_ = 0.0;
    sample_flags_ = bit(EstimateFlag::kNotExciting);
    errors_.interrupt();
  }
  if (steady && smoothed_ticks_ * scales_.period_s >= own_.smoothing_s && since_alarm_s_ >= kCalm_s) {
    learn();
  }
}

plant::OperatingPoint ValveFlowEstimator::point_of(const Eigen::Vector3d& state) const noexcept {
  return {.position = std::clamp(state(0), 0.0, actuator_.stroke),
          .load_pressure_Pa = (state(2) + actuator_.piston_damping * state(1)) / actuator_.area_a,
          .valve_sign = sign_};
}

void ValveFlowEstimator::interrupt() noexcept {
  oil_.interrupt();
  smoothed_ticks_ = 0.0;
  errors_.interrupt();
}

// The mean of what came since the interruption, until that is longer than the filter's memory.
void ValveFlowEstimator::smooth(const Terms& now) noexcept {
  smoothed_ticks_ += 1.0;
  const double share = std::max(1.0 / smoothed_ticks_, scales_.period_s / (own_.smoothing_s + scales_.period_s));
  smooth_ += share * (now - smooth_);
}

void ValveFlowEstimator::learn() noexcept {
  const Parameters parts = smooth_.segment<kParameters>(kParts);
  const double deviation = std::hypot(own_.flow_error, smooth_(kCompression), smooth_(kSupply));
  const double error = (smooth_(kFlow) - parts.dot(prior_)) / deviation;
  const Parameters scaled = parts.cwiseProduct(deviation_) / deviation;
  const double unexpected = error - regression_.parameters().row(0).dot(scaled);
  errors_.take(unexpected);
  surplus_ = PredictionErrors::kMemory * surplus_ + (parts(kGainPart) > 0.0 ? unexpected : -unexpected);
  const double usual = std::sqrt(std::max(kLeastResidual, regression_.residual_variance()(0)));
  if (std::sqrt(errors_.variance()) > own_.change_threshold * usual) {
    sample_flags_ |= bit(EstimateFlag::kMisfit);
    if (surplus_ > 0.0 || unexpected * parts(kGainPart) > 0.0) {
      count_as_stronger();
    } else {
      begin_from(regression_.parameters());
    }
  }
  if (regression_.update(scaled, {error, 0.0, 0.0}) == RlsStatus::kCovarianceNotPositiveDefinite) {
    sample_flags_ |= bit(EstimateFlag::kCovarianceRepaired);
  }
}

// A loop whose gain was right before oscillates because the valve has become stronger. Samples do not tell so soon: the valve
// changes sides before the chambers have taken their oil.
void ValveFlowEstimator::watch(const JointSample& sample) noexcept {
  stronger_ = stronger_ && regression_.samples() < params_.min_samples;
  since_alarm_s_ += scales_.period_s;
  if (since_alarm_s_ < kDeaf_s) {
    loop_.reset();
  }
  if (!loop_.take(sample.force_error / (actuator_.area_a * actuator_.supply_pressure_Pa))) {
    return;
  }
  since_alarm_s_ = 0.0;
  const double gain = parameters()(kGainPart);
  const bool known = regression_.samples() >= params_.min_samples;
  const bool same_valve = known && std::abs(gain / alarm_gain_ - 1.0) < kSameValve;
  count_as_stronger();
  if (same_valve) {
    count_as_stiffer();
  }
  alarm_gain_ = known ? gain : alarm_gain_;
}

// A law for a weaker valve than there is may be unstable; a law for a stronger one is slow.
void ValveFlowEstimator::count_as_stronger() noexcept {
  stronger_ = true;
  Parameters all = linear_parts();
  all.head<2>() *= std::clamp(kStrongest / all(kGainPart), 1.0, 1.0 + own_.gain_uncertainty);
  Rls<kParameters>::Parameters raised = regression_.parameters();
  raised.row(0) = (all - prior_).cwiseQuotient(deviation_).transpose();
  begin_from(raised);
}

// The gain of the loop goes with that of the valve over the compressibility of the oil.
void ValveFlowEstimator::count_as_stiffer() noexcept {
  held_compressibility_ = std::max(kLeastCompressibility, held_compressibility_ / kStiffer);
  Rls<kParameters>::Parameters stiffer = regression_.parameters();
  stiffer(0, kCompressibilityPart) =
      (held_compressibility_ - 1.0 - prior_(kCompressibilityPart)) / deviation_(kCompressibilityPart);
  regression_.reset(stiffer, regression_.covariance().diagonal());
}

// The valve is as uncertain as at the start: samples before its change count no more. Damping and oil do not change with it.
void ValveFlowEstimator::begin_from(const Rls<kParameters>::Parameters& parameters) noexcept {
  held_compressibility_ = compressibility();
  Parameters variances = regression_.covariance().diagonal();
  variances.head<kValveParts>().setOnes();
  variances.tail<kParameters - kValveParts>() *= kLessSure;
  regression_.reset(parameters, variances);
  errors_ = PredictionErrors();
  surplus_ = 0.0;
}

}  // namespace farrier::estimation
