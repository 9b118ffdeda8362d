#include "diagnosis/model/electric_starts.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/data/sample_statistics.hpp"
#include "diagnosis/model/sinusoid_balance.hpp"
#include "diagnosis/model/start_range.hpp"
#include "plant/coulomb_friction.hpp"
#include "plant/terms/electric_effects.hpp"

namespace farrier::diagnosis {
namespace {

constexpr double kMostPeriods = 600.0;
constexpr std::size_t kMostStarts = 3;
constexpr double kUnlimitedShare = 0.5;  ///< of the largest command, up to which the balance of a rotor trusts it

/// The torque on the load less that of its spring, beside its inertia, damping and dry friction.
Balance balance_of_load(const JointData& data, const plant::ElectricParams& drive, const plant::LoadParams& load,
                        bool with_spring) {
  const std::vector<std::size_t> samples = balance_samples(data);
  Balance balance = balance_over(samples, with_spring ? 5 : 3);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t k = samples[i];
    const auto row = static_cast<Eigen::Index>(i);
    balance.position[row] = data.position[k];
    balance.force[row] = data.force[k] - load.stiffness * (data.position[k] - load.equilibrium_position);
    balance.terms(row, 0) = data.acceleration[k];
    balance.terms(row, 1) = data.velocity[k];
    balance.terms(row, 2) = plant::coulomb_friction(1.0, data.velocity[k], drive.slip_velocity);
    if (with_spring) {
      balance.terms(row, 3) = 1.0;
      balance.terms(row, 4) = data.position[k];
    }
  }
  return balance;
}

/// Torque at the sensor beside that of the command, of rotor speed and acceleration and dry friction. Samples of large
/// currents are left out: the motor may have had less.
Balance balance_of_rotor(const JointData& data, const plant::ElectricParams& drive) {
  std::vector<std::size_t> samples = balance_samples(data);
  const double most_A = kUnlimitedShare * magnitude(data.current_A, 1.0);
  std::erase_if(samples, [&](std::size_t k) { return std::abs(data.current_A[k - 1]) > most_A; });
  Balance balance = balance_over(samples, 5);
  const double h = data.period_s;
  const auto speed = [&](std::size_t k) {
    return data.velocity[k] + (data.force[k + 1] - data.force[k - 1]) / (2.0 * h * drive.spring_stiffness);
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t k = samples[i];
    const auto row = static_cast<Eigen::Index>(i);
    balance.position[row] = data.position[k] + data.force[k] / drive.spring_stiffness;
    balance.force[row] = -data.force[k];
    balance.terms(row, 0) = data.current_A[k - 1];
    balance.terms(row, 1) = speed(k);
    balance.terms(row, 2) = (speed(k + 1) - speed(k - 1)) / (2.0 * h);
    balance.terms(row, 3) = 1.0;
    balance.terms(row, 4) = plant::coulomb_friction(1.0, speed(k), drive.slip_velocity);
  }
  return balance;
}

/// The strongest ripples over a grid of periods per turn.
std::vector<Sinusoid> strongest(const Balance& balance) {
  const double step = std::max(telling_step(balance), kMostPeriods / 2000.0);
  return strongest_sinusoids(balance, {std::max(4.0 * step, 1.0), kMostPeriods, step}, kMostStarts);
}

}  // namespace

std::vector<std::vector<double>> starts_of_limit(const JointData& data, const plant::Scales& scales) {
  const double peak = magnitude(data.current_A, 1.0);
  std::vector<std::vector<double>> starts;
  for (const double share : {0.85, 0.5}) {
    if (peak > 0.0) {
      starts.push_back(
          {within_range(plant::kCurrentLimitParameters[0], scales.of(plant::Scale::kCurrent) / (share * peak))});
    }
  }
  return starts;
}

std::vector<std::vector<double>> starts_of_cogging(const JointData& data, const plant::ElectricParams& drive,
                                                   const plant::LoadParams& load, const plant::Scales& scales) {
  if (!has_balance(data) || (!drive.rigid && data.current_A.empty())) {
    return {};
  }
  const Balance balance = drive.rigid ? balance_of_load(data, drive, load, true) : balance_of_rotor(data, drive);
  const auto& [amplitude, periods, phase] = plant::kCoggingParameters;
  std::vector<std::vector<double>> starts;
  for (const Sinusoid& peak : strongest(balance)) {
    // The balance has the torque that the ripple takes away: -A sin(q x + p).
    const double size = std::hypot(peak.sine, peak.cosine) / scales.of(plant::Scale::kForce);
    starts.push_back({within_range(amplitude, size), within_range(periods, peak.periods),
                      within_range(phase, std::atan2(-peak.cosine, -peak.sine))});
  }
  return starts;
}

std::vector<std::vector<double>> starts_of_gravity(const JointData& data, const plant::ElectricParams& drive,
                                                   const plant::LoadParams& load, const plant::Scales& scales) {
  if (!has_balance(data)) {
    return {};
  }
  const Balance balance = balance_of_load(data, drive, load, false);
  // M sin(x - x_h) = M cos(x_h) sin(x) - M sin(x_h) cos(x)
  const Sinusoid weight = sinusoid_of(balance, 1.0);
  const double size = std::hypot(weight.sine, weight.cosine) / scales.of(plant::Scale::kForce);
  return {{within_range(plant::kGravityParameters[0], size), std::atan2(-weight.cosine, weight.sine)}};
}

}  // namespace farrier::diagnosis
