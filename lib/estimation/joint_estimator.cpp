#include "estimation/joint_estimator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "core/ticks_since.hpp"
#include "estimation/poles.hpp"

namespace farrier::estimation {
namespace {

// The constant's entry in the regressor: near the other entries' size, so that one initial covariance suits all.
constexpr double kBiasEntry = 0.1;
// The first prediction error variance is this many times the sensors' variance: sensors are trusted first.
constexpr double kFirstInnovation = 100.0;
// Least share of a prediction error that corrects the state: a model is never trusted completely.
constexpr double kLeastCorrection = 0.05;
// Longest step between samples that the washout bridges: the error is small compared with a restart.
constexpr std::uint64_t kBridgedTicks = 3;
// Time constants per stage after which the washout's start is forgotten: to 2 % with one stage, to 5e-4 with three.
// Until then the linear model does not hold for its output: x[0] is its own mean, and the mean of A x[0] + B u[0] is
// not x[1].
constexpr double kSettlingTimeConstants = 4.0;

std::uint32_t flags_of(RlsStatus status) noexcept {
  switch (status) {
    case RlsStatus::kRegressorTooSmall:
      return bit(EstimateFlag::kRegressorTooSmall);
    case RlsStatus::kCovarianceNotPositiveDefinite:
      return bit(EstimateFlag::kCovarianceRepaired);
    case RlsStatus::kNotFinite:
      return bit(EstimateFlag::kSampleRefused);
    case RlsStatus::kNotYetSet:
    case RlsStatus::kOk:
      break;
  }
  return 0;
}

}  // namespace

Result<JointEstimator> JointEstimator::create(const EstimatorParams& params, const JointScales& scales,
                                              const Eigen::Matrix3d& prior_a, const Eigen::Vector3d& prior_b) {
  if (params.operating_point_order < 0 || params.operating_point_order > Washout::kMaxOrder) {
    return Error{"operating_point_order must be 0 to 4"};
  }
  const auto positive = [](double x) { return x > 0.0 && std::isfinite(x); };
  if (!positive(params.full_weight_norm) || !positive(params.operating_point_time_constant_s)) {
    return Error{"full_weight_norm and operating_point_time_constant_s must be positive"};
  }
  if (!(params.innovation_forgetting >= 0.0 && params.innovation_forgetting < 1.0) ||
      !(params.stability_limit > 0.0 && params.stability_limit < 1.0)) {
    return Error{"innovation_forgetting must be in [0, 1), stability_limit in (0, 1)"};
  }
  if (!(params.model_error >= 0.0 && params.model_error <= 1.0)) {
    return Error{"model_error must be in [0, 1]"};
  }
  if (!(params.regressor_min >= 0.0 && std::isfinite(params.regressor_min)) || params.blank_ticks < 0 ||
      params.min_samples < 1) {
    return Error{"regressor_min and blank_ticks must not be negative, min_samples at least 1"};
  }
  FARRIER_TRY(validate(scales));
  // T^-1 A T, T^-1 B V
  const Eigen::Matrix3d a = scales.state.cwiseInverse().asDiagonal() * prior_a * scales.state.asDiagonal();
  const Eigen::Vector3d b = scales.current_A * prior_b.cwiseQuotient(scales.state);
  const Eigen::Vector3d noise_variance = scales.sensor_noise.cwiseQuotient(scales.state).array().square();
  auto regression = FARRIER_TRY(make_regression(params, noise_variance, a, b));
  auto gate = FARRIER_TRY(ExcitationGate::create(params));
  return JointEstimator(params, scales, {std::move(regression), Eigen::Vector3d::Zero(), {}}, std::move(gate));
}

JointEstimator::JointEstimator(const EstimatorParams& params, const JointScales& scales, PhaseMemory memory,
                               ExcitationGate gate)
    : params_(params),
      scales_(scales),
      noise_variance_(scales.sensor_noise.cwiseQuotient(scales.state).array().square()),
      kinematic_step_(scales.period_s * scales.state(1) / scales.state(0)),
      washout_(std::min(1.0, scales.period_s / std::max(params.operating_point_time_constant_s, scales.period_s)),
               params.operating_point_order),
      settling_ticks_(static_cast<int>(std::ceil(kSettlingTimeConstants * params.operating_point_order *
                                                 params.operating_point_time_constant_s / scales.period_s))),
      gate_(std::move(gate)),
      memories_{memory, memory} {
  for (PhaseMemory& each : memories_) {
    each.innovation_variance = kFirstInnovation * noise_variance_;
  }
}

void JointEstimator::restart(const Eigen::Vector4d& washed) noexcept {
  filtered_ = washed.head<3>();
  simulated_ = filtered_;
  inputs_ = {washed(3), 0.0, 0.0};
  inputs_known_ = 1;
  gate_.reset();
  interrupt_errors();
}

void JointEstimator::interrupt_errors() noexcept {
  for (PhaseMemory& each : memories_) {
    each.force_errors.interrupt();
  }
}

void JointEstimator::take(const JointSample& sample) noexcept {
  Eigen::Vector4d signal;
  signal << (sample.state - Eigen::Vector3d(scales_.home_position, 0, 0)).cwiseQuotient(scales_.state),
      sample.current_A / scales_.current_A;
  if (!(signal.array().abs() <= kLargestSignal).all() || sample.phase < 0 || sample.phase > 1) {
    sample_flags_ = (sample_flags_ & bit(EstimateFlag::kBlanked)) | bit(EstimateFlag::kSampleRefused);
    return;
  }
  const std::uint64_t since = last_tick_ == kNoTick ? 0 : ticks_since(last_tick_, sample.tick);
  const bool follows = since == 1;
  unsettled_ticks_ = std::max(unsettled_ticks_ - 1, 0);
  if (since < 1 || since > kBridgedTicks) {
    washout_.reset();
    unsettled_ticks_ = settling_ticks_;
  }
  const Eigen::Vector4d washed = washout_.pass(signal);
  ticks_in_phase_ = sample.phase == phase_ ? ticks_in_phase_ + 1 : 0;
  phase_ = sample.phase;
  last_tick_ = sample.tick;
  sample_flags_ = ticks_in_phase_ > params_.blank_ticks ? 0 : bit(EstimateFlag::kBlanked);
  if (!follows) {
    restart(washed);
    return;
  }
  gate_.observe(washed);
  if (sample_flags_ == 0 && unsettled_ticks_ == 0 && inputs_known_ > scales_.input_delay_ticks) {
    PhaseMemory& known = memory(phase_);
    std::visit([&](auto& engine) { update(engine, known, washed.head<3>()); }, known.regression);
  } else {
    filtered_ = washed.head<3>();
    simulated_ = filtered_;
    interrupt_errors();
  }
  inputs_ = {washed(3), inputs_[0], inputs_[1]};
  inputs_known_ = std::min(inputs_known_ + 1, 3);
}

template <class Engine>
void JointEstimator::update(Engine& engine, PhaseMemory& known, const Eigen::Vector3d& measured) noexcept {
  using Regressor = typename Engine::Regressor;
  const Columns columns = columns_of(params_.position);
  const auto regressor = [&](const Eigen::Vector3d& state) {
    Regressor h;
    if (params_.position) {
      h(0) = state(0);
    }
    h(columns.velocity) = state(1);
    h(columns.force) = state(2);
    h(columns.input) = inputs_[static_cast<std::size_t>(scales_.input_delay_ticks)];
    if (params_.bias) {
      h(columns.bias) = kBiasEntry;
    }
    return h;
  };
  const Regressor h = regressor(filtered_);
  const double norm = h.head(columns.bias).norm();
  const auto prediction = [&](const Regressor& from) {
    Eigen::Vector3d y = engine.parameters() * from;
    if (!params_.position) {
      y(0) = measured(0);
    }
    return y;
  };
  const double memory = params_.innovation_forgetting;
  const Eigen::Vector3d innovation = measured - prediction(h);
  const Eigen::Vector3d innovation_squared = innovation.array().square();
  known.innovation_variance = memory * known.innovation_variance + (1.0 - memory) * innovation_squared;
  known.force_errors.take(innovation(2));
  // Large motion is where the joint is least linear: (h, y) / sqrt(1 + |h|^2 / h_0^2).
  const double ratio = norm / params_.full_weight_norm;
  const double weight = 1.0 / std::sqrt(1.0 + ratio * ratio);
  const Regressor instrument = kTakesInstrument<Engine> ? regressor(simulated_) : h;
  // (6.24) without the constant, which carries no information.
  if (norm < params_.regressor_min) {
    sample_flags_ |= bit(EstimateFlag::kRegressorTooSmall);
  } else if (!gate_.open()) {
    sample_flags_ |= bit(EstimateFlag::kNotExciting);
  } else {
    const RlsStatus status = teach(engine, weight, h, measured, instrument);
    const bool limited = status == RlsStatus::kOk && engine.forgetting_limited();
    sample_flags_ |= flags_of(status) | (limited ? bit(EstimateFlag::kForgettingAtLimit) : 0);
  }

  if constexpr (kTakesInstrument<Engine>) {
    filtered_ = measured;
    simulated_ = prediction(instrument);
    if (engine.instrument_refused() || !(simulated_.array().abs() <= kLargestSignal).all()) {
      sample_flags_ |= bit(EstimateFlag::kInstrumentRefused);
      simulated_ = measured;
    }
  } else {
    const Eigen::Vector3d predicted = prediction(h);
    // L = 1 - R / S, scalar by channel
    const Eigen::Vector3d correction =
        (1.0 - noise_variance_.array() / known.innovation_variance.array().max(1e-300)).max(kLeastCorrection).min(1.0);
    filtered_ = predicted + correction.cwiseProduct(measured - predicted);
  }
}

template <class Engine>
void JointEstimator::read(const Engine& engine, const PredictionErrors& force_errors,
                          ModelEstimate& out) const noexcept {
  const Columns columns = columns_of(params_.position);
  const auto& theta = engine.parameters();
  // The estimated rows are velocity and force.
  const std::array<typename Engine::Covariance, 2> covariance{engine.covariance(1), engine.covariance(2)};
  const double unmodelled = params_.model_error * params_.model_error;
  const Eigen::Vector3d residual = engine.residual_variance().cwiseMax(0.0).array() + unmodelled;
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = theta.col(columns.input);
  a.col(1) = theta.col(columns.velocity);
  a.col(2) = theta.col(columns.force);
  if (params_.position) {
    a.col(0) = theta.col(0);
  }
  a.row(0) << 1.0, kinematic_step_, 0.0;
  b(0) = 0.0;
  const auto error = [&](int row, int column) {
    return std::sqrt(residual(row) * covariance[static_cast<std::size_t>(row - 1)](column, column));
  };
  for (int row = 1; row < 3; ++row) {
    out.a_error(row, 0) = params_.position ? error(row, 0) : 0.0;
    out.a_error(row, 1) = error(row, columns.velocity);
    out.a_error(row, 2) = error(row, columns.force);
    out.b_error(row) = error(row, columns.input);
    out.c(row) = params_.bias ? theta(row, columns.bias) * kBiasEntry : 0.0;
  }

  // var = n_F^2 + (a_32 n_v)^2 + (a_33 n_F)^2 + model_error^2
  const double explained =
      noise_variance_(2) * (1.0 + a(2, 2) * a(2, 2)) + a(2, 1) * a(2, 1) * noise_variance_(1) + unmodelled;
  out.prediction_error = explained > 0.0 ? std::sqrt(force_errors.variance() / explained) : 0.0;
  out.whiteness = force_errors.whiteness();
  if (out.prediction_error > kMisfitFree) {
    out.flags |= bit(EstimateFlag::kMisfit);
  }
  out.b_error(2) += kMisfitError * std::max(0.0, out.prediction_error - kMisfitFree) * std::abs(b(2));

  // Only velocity and force are uncertain: the position is their exact sum.
  Eigen::Matrix2d loop = a.bottomRightCorner<2, 2>();
  switch (map_to_stable<2>(loop, params_.stability_limit)) {
    case StabilityStatus::kMappedToStable:
      out.flags |= bit(EstimateFlag::kMappedToStable);
      a.bottomRightCorner<2, 2>() = loop;
      break;
    case StabilityStatus::kEigenvalueError:
      out.flags |= bit(EstimateFlag::kEigenvalueError);
      break;
    case StabilityStatus::kNotYetSet:
    case StabilityStatus::kStable:
      break;
  }
  const auto block = [&](std::size_t row) -> Eigen::Matrix2d {
    return covariance[row].template block<2, 2>(columns.velocity, columns.velocity);
  };
  const std::array<Eigen::Matrix2d, 2> blocks{block(0), block(1)};
  const auto errors = pole_standard_error<2>(loop, poles<2>(loop), residual.tail<2>(), blocks);
  const double pole_error = std::max(errors[0], errors[1]);
  if (!(b(2) > 0.0 && a(1, 2) > 0.0)) {
    out.flags |= bit(EstimateFlag::kNotPhysical);
  }
  out.samples = static_cast<std::uint32_t>(std::min<std::int64_t>(engine.samples(), UINT32_MAX));
  if (engine.samples() < params_.min_samples) {
    out.flags |= bit(EstimateFlag::kNotYetSet);
  }
  constexpr std::uint32_t kForbidding = bit(EstimateFlag::kNotPhysical) | bit(EstimateFlag::kNotYetSet) |
                                        bit(EstimateFlag::kBlanked) | bit(EstimateFlag::kEigenvalueError);
  out.validity = (out.flags & kForbidding) != 0 ? 0.0 : std::clamp(1.0 - pole_error / kUselessPoleError, 0.0, 1.0);
  out.excitation = 1.0 / engine.covariance_trace();

  // Back to SI: T A T^-1, T B V^-1.
  const auto to_si = scales_.state.asDiagonal();
  const auto from_si = scales_.state.cwiseInverse().asDiagonal();
  out.a = to_si * a * from_si;
  out.a_error = (to_si * out.a_error * from_si).eval();
  out.b = scales_.state.cwiseProduct(b) / scales_.current_A;
  out.b_error = scales_.state.cwiseProduct(out.b_error) / scales_.current_A;
  out.c = scales_.state.cwiseProduct(out.c);
}

ModelEstimate JointEstimator::estimate() const noexcept {
  ModelEstimate out;
  out.phase = std::max(phase_, 0);
  out.flags = phase_ < 0 ? bit(EstimateFlag::kNotYetSet) : sample_flags_;
  const PhaseMemory& known = memory(out.phase);
  std::visit([&](const auto& engine) { read(engine, known.force_errors, out); }, known.regression);
  return out;
}

Eigen::Vector3d JointEstimator::forgetting(int phase) const noexcept {
  return std::visit([](const auto& engine) -> Eigen::Vector3d { return engine.forgetting(); },
                    memory(phase).regression);
}

}  // namespace farrier::estimation
