#include "diagnosis/model/load_starts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "diagnosis/model/model.hpp"
#include "diagnosis/model/sinusoid_balance.hpp"
#include "diagnosis/model/start_range.hpp"
#include "plant/coulomb_friction.hpp"
#include "plant/terms/position_dependent_friction.hpp"
#include "plant/terms/spring_hardening.hpp"

namespace farrier::diagnosis {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kSlipShare = 0.01;  ///< of the joint's speed, below which the balance takes friction as undecided
constexpr std::size_t kMostWaves = 2;
/// Waves that are tried, in telling steps: from 1.7 times the recorded way down to a tenth of it.
constexpr double kLongestWave = 2.0;
constexpr double kShortestWave = 34.0;
/// Places of the terms of a load: inertia, damping, dry friction, and the powers of a spring's force from 0 on.
constexpr Eigen::Index kFriction = 2;
constexpr Eigen::Index kPowers = 3;

/// Middle and half of the recorded way, m or rad.
struct Way {
  double middle, reach;
};

Way way_of(const Balance& balance) {
  const double low = balance.position.minCoeff();
  const double high = balance.position.maxCoeff();
  return {0.5 * (low + high), 0.5 * (high - low)};
}

/// The balance of a load, whose spring has powers of the position up to `highest`, over the recorded way, -1 to 1, where
/// they are nearly independent. The sinusoid acts along the dry friction. No balance without a recorded way of the load.
std::optional<Balance> balance_of_load(const JointData& data, const plant::Scales& scales, Eigen::Index highest) {
  const std::vector<std::size_t> samples = balance_samples(data);
  if (!has_balance(data) || samples.empty()) {
    return std::nullopt;
  }
  Balance balance = balance_over(samples, kPowers + highest + 1);
  balance.along.resize(balance.position.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    balance.position[static_cast<Eigen::Index>(i)] = data.position[samples[i]];
  }
  const Way way = way_of(balance);
  if (!(way.reach > 0.0)) {
    return std::nullopt;
  }
  const double slip_velocity = kSlipShare * scales.of(plant::Scale::kSpeed);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t k = samples[i];
    const auto row = static_cast<Eigen::Index>(i);
    const double u = (data.position[k] - way.middle) / way.reach;
    balance.force[row] = data.force[k];
    balance.along[row] = plant::coulomb_friction(1.0, data.velocity[k], slip_velocity);
    balance.terms.row(row).head(kPowers) << data.acceleration[k], data.velocity[k], balance.along[row];
    for (Eigen::Index power = 0; power <= highest; ++power) {
      balance.terms(row, kPowers + power) = std::pow(u, static_cast<int>(power));
    }
  }
  return balance;
}

/// Numbers of the effect: F_c (1 + w cos(q (x - x_t))) along the motion is F_c + b sin(q x) + c cos(q x).
std::vector<double> start_of(const Balance& balance, const Sinusoid& wave, const plant::Scales& scales) {
  const auto& parameters = plant::kWavyContactParameters;
  constexpr std::size_t kWaviness = plant::kContactParameters.size();
  const double length = scales.of(plant::Scale::kLength);
  const double least = parameters[0].low * scales.of(plant::Scale::kForce);
  const double coulomb = std::max(terms_beside(balance, wave)[kFriction], least);
  const double wavelength = kTurn / wave.periods;
  const double tightest = std::atan2(wave.sine, wave.cosine) / wave.periods;
  // The tightest place that is nearest to the middle of the motion.
  const double middle = way_of(balance).middle;
  const double next = tightest + wavelength * std::round((middle - tightest) / wavelength);
  std::vector<double> start;
  for (const plant::Parameter& parameter : parameters) {
    start.push_back(parameter.starts[0]);
  }
  start[0] = within_range(parameters[0], coulomb / scales.of(plant::Scale::kForce));
  start[kWaviness] = within_range(parameters[kWaviness], std::hypot(wave.sine, wave.cosine) / coulomb);
  start[kWaviness + 1] = within_range(parameters[kWaviness + 1], wavelength / length);
  start[kWaviness + 2] = within_range(parameters[kWaviness + 2], next / length);
  return start;
}

/// True if the waviness of a start lies within its range.
bool swings(const std::vector<double>& start) {
  const plant::Parameter& waviness = plant::kWavyContactParameters[plant::kContactParameters.size()];
  const double number = start[plant::kContactParameters.size()];
  return number > waviness.low && number < waviness.high;
}

}  // namespace

std::vector<std::vector<double>> starts_of_friction_wave(const JointData& data, const plant::Scales& scales) {
  std::vector<std::vector<double>> starts;
  if (const auto balance = balance_of_load(data, scales, 1)) {
    const double step = telling_step(*balance);
    const PeriodGrid grid{kLongestWave * step, kShortestWave * step, step};
    for (const Sinusoid& wave : strongest_sinusoids(*balance, grid, kMostWaves)) {
      starts.push_back(start_of(*balance, wave, scales));
    }
    // Starts whose waviness lies at an end of its range are left out, but for one if all do.
    const auto ends = std::ranges::stable_partition(starts, swings);
    starts.erase(std::max(ends.begin(), starts.begin() + std::min<std::ptrdiff_t>(1, std::ssize(starts))),
                 starts.end());
  }
  return starts.empty() ? starts_of(plant::PositionDependentFriction<double>::kInfo) : starts;
}

std::vector<std::vector<double>> starts_of_hardening(const JointData& data, const plant::Scales& scales) {
  const auto balance = balance_of_load(data, scales, 3);
  if (!balance) {
    return {};
  }
  const Eigen::VectorXd spring = linear_terms(*balance).tail(4);
  if (spring[3] == 0.0) {
    return {};
  }
  const Way way = way_of(*balance);
  const double cubic = spring[3] / (way.reach * way.reach * way.reach);
  // k (x - x_eq)^3 has the square -3 k x_eq.
  const double slack = way.middle - way.reach * spring[2] / (3.0 * spring[3]);
  const auto& parameters = plant::SpringHardening<double>::kParameters;
  return {{within_range(parameters[0], cubic / scales.of(plant::Scale::kCubic)),
           within_range(parameters[1], slack / scales.of(plant::Scale::kLength))}};
}

}  // namespace farrier::diagnosis
