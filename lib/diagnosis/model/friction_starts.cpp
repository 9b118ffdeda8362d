#include "diagnosis/model/friction_starts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnosis/model/model.hpp"
#include "diagnosis/model/sinusoid_balance.hpp"
#include "diagnosis/model/start_range.hpp"
#include "plant/coulomb_friction.hpp"
#include "plant/terms/position_dependent_friction.hpp"

namespace farrier::diagnosis {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kSlipShare = 0.01;  ///< of the joint's speed, below which the balance takes friction as undecided
constexpr std::size_t kMostWaves = 2;
/// Waves that are tried, in telling steps: from 1.7 times the recorded way down to a tenth of it.
constexpr double kLongestWave = 2.0;
constexpr double kShortestWave = 34.0;
constexpr Eigen::Index kFriction = 4;  ///< place of the level friction among the terms

Balance balance_of_friction(const JointData& data, double slip_velocity) {
  const std::vector<std::size_t> samples = balance_samples(data);
  Balance balance = balance_over(samples, kFriction + 1);
  balance.along.resize(balance.position.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t k = samples[i];
    const auto row = static_cast<Eigen::Index>(i);
    balance.position[row] = data.position[k];
    balance.force[row] = data.force[k];
    balance.along[row] = plant::coulomb_friction(1.0, data.velocity[k], slip_velocity);
    balance.terms.row(row) << data.acceleration[k], data.velocity[k], 1.0, data.position[k], balance.along[row];
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
  const double middle = 0.5 * (balance.position.minCoeff() + balance.position.maxCoeff());
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
  if (has_balance(data)) {
    const Balance balance = balance_of_friction(data, kSlipShare * scales.of(plant::Scale::kSpeed));
    const double step = telling_step(balance);
    const PeriodGrid grid{kLongestWave * step, kShortestWave * step, step};
    for (const Sinusoid& wave : strongest_sinusoids(balance, grid, kMostWaves)) {
      starts.push_back(start_of(balance, wave, scales));
    }
    // Starts whose waviness lies at an end of its range are left out, but for one if all do.
    const auto ends = std::ranges::stable_partition(starts, swings);
    starts.erase(std::max(ends.begin(), starts.begin() + std::min<std::ptrdiff_t>(1, std::ssize(starts))),
                 starts.end());
  }
  return starts.empty() ? starts_of(plant::PositionDependentFriction<double>::kInfo) : starts;
}

}  // namespace farrier::diagnosis
