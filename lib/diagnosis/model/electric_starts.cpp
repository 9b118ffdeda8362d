#include "diagnosis/model/electric_starts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "diagnosis/data/sample_statistics.hpp"
#include "plant/coulomb_friction.hpp"
#include "plant/terms/electric_effects.hpp"

namespace farrier::diagnosis {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;
/// Samples of a balance of torques: every other.
constexpr std::size_t kEvery = 2;
constexpr std::size_t kMargin = 20;  ///< from the ends, where the smoothed motion settles
constexpr double kMostPeriods = 600.0;
constexpr double kGridShare = 0.3;  ///< of the distance at which a sinusoid over the recorded positions is another
constexpr std::size_t kMostStarts = 3;

/// Torque that a model of linear terms leaves unexplained, by position.
struct Balance {
  Eigen::VectorXd position, torque;
  Eigen::MatrixXd terms;  ///< a column per linear term
};

/// A sinusoid b sin(q x) + c cos(q x) beside the terms: its numbers, and the squares that it explains.
struct Sinusoid {
  double periods, sine, cosine, explained;  ///< periods per turn
};

Sinusoid sinusoid_of(const Balance& balance, const Eigen::LLT<Eigen::MatrixXd>& normal, const Eigen::VectorXd& left,
                     double periods) {
  Eigen::MatrixXd wave(balance.position.size(), 2);
  wave.col(0) = (periods * balance.position.array()).sin();
  wave.col(1) = (periods * balance.position.array()).cos();
  const Eigen::MatrixXd cross = balance.terms.transpose() * wave;
  Eigen::Matrix2d own = wave.transpose() * wave - cross.transpose() * normal.solve(cross);
  own.diagonal().array() += 1e-9 * static_cast<double>(balance.position.size());
  const Eigen::Vector2d along = wave.transpose() * left;
  const Eigen::Vector2d amplitudes = own.llt().solve(along);
  return {periods, amplitudes[0], amplitudes[1], amplitudes.dot(along)};
}

struct Fit {
  Eigen::LLT<Eigen::MatrixXd> normal;
  Eigen::VectorXd left;
};
Fit fit_of(const Balance& balance) {
  Eigen::MatrixXd square = balance.terms.transpose() * balance.terms;
  square.diagonal() *= 1.0 + 1e-9;
  square.diagonal().array() += 1e-300;
  Fit fit{square.llt(), {}};
  fit.left = balance.torque - balance.terms * fit.normal.solve(balance.terms.transpose() * balance.torque);
  return fit;
}

std::vector<std::size_t> chosen_samples(const JointData& data) {
  std::vector<std::size_t> chosen;
  for (std::size_t k = kMargin; k + kMargin < data.size(); k += kEvery) {
    if (data.swing.empty() || data.swing[k] != 0) {
      chosen.push_back(k);
    }
  }
  return chosen;
}

Balance balance_over(const std::vector<std::size_t>& samples, Eigen::Index terms) {
  const auto rows = static_cast<Eigen::Index>(samples.size());
  return {Eigen::VectorXd(rows), Eigen::VectorXd(rows), Eigen::MatrixXd(rows, terms)};
}

/// The torque on the load less that of its spring, beside its inertia, damping and dry friction.
Balance balance_of_load(const JointData& data, const plant::ElectricParams& drive, const plant::LoadParams& load,
                        bool with_spring) {
  const std::vector<std::size_t> samples = chosen_samples(data);
  Balance balance = balance_over(samples, with_spring ? 5 : 3);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t k = samples[i];
    const auto row = static_cast<Eigen::Index>(i);
    balance.position[row] = data.position[k];
    balance.torque[row] = data.force[k] - load.stiffness * (data.position[k] - load.equilibrium_position);
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

/// Torque at the sensor beside that of the command, of rotor speed and acceleration and dry friction.
Balance balance_of_rotor(const JointData& data, const plant::ElectricParams& drive) {
  const std::vector<std::size_t> samples = chosen_samples(data);
  Balance balance = balance_over(samples, 5);
  const double h = data.period_s;
  const auto speed = [&](std::size_t k) {
    return data.velocity[k] + (data.force[k + 1] - data.force[k - 1]) / (2.0 * h * drive.spring_stiffness);
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t k = samples[i];
    const auto row = static_cast<Eigen::Index>(i);
    balance.position[row] = data.position[k] + data.force[k] / drive.spring_stiffness;
    balance.torque[row] = -data.force[k];
    balance.terms(row, 0) = data.current_A[k - 1];
    balance.terms(row, 1) = speed(k);
    balance.terms(row, 2) = (speed(k + 1) - speed(k - 1)) / (2.0 * h);
    balance.terms(row, 3) = 1.0;
    balance.terms(row, 4) = plant::coulomb_friction(1.0, speed(k), drive.slip_velocity);
  }
  return balance;
}

/// The strongest peaks over the grid of periods.
std::vector<Sinusoid> strongest(const Balance& balance) {
  const double range = balance.position.maxCoeff() - balance.position.minCoeff();
  if (!(range > 0.0)) {
    return {};
  }
  const Fit fit = fit_of(balance);
  const double step = std::max(kGridShare * kFullTurn / range, kMostPeriods / 2000.0);
  std::vector<Sinusoid> grid;
  for (double q = std::max(4.0 * step, 1.0); q < kMostPeriods; q += step) {
    grid.push_back(sinusoid_of(balance, fit.normal, fit.left, q));
  }
  std::vector<Sinusoid> peaks;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const bool rises = i == 0 || grid[i].explained >= grid[i - 1].explained;
    const bool falls = i + 1 == grid.size() || grid[i].explained > grid[i + 1].explained;
    if (rises && falls) {
      peaks.push_back(grid[i]);
    }
  }
  std::ranges::sort(peaks, std::greater{}, &Sinusoid::explained);
  peaks.resize(std::min(peaks.size(), kMostStarts));
  return peaks;
}

double within(const plant::Parameter& parameter, double fitted) {
  return std::clamp(fitted, parameter.low, parameter.high);
}

}  // namespace

std::vector<std::vector<double>> starts_of_limit(const JointData& data, const plant::Scales& scales) {
  const double peak = magnitude(data.current_A, 1.0);
  std::vector<std::vector<double>> starts;
  for (const double share : {0.85, 0.5}) {
    if (peak > 0.0) {
      starts.push_back({within(plant::kCurrentLimitParameters[0], scales.of(plant::Scale::kCurrent) / (share * peak))});
    }
  }
  return starts;
}

std::vector<std::vector<double>> starts_of_cogging(const JointData& data, const plant::ElectricParams& drive,
                                                   const plant::LoadParams& load, const plant::Scales& scales) {
  if (data.size() < 8 * kMargin || (!drive.rigid && data.current_A.empty())) {
    return {};
  }
  const Balance balance = drive.rigid ? balance_of_load(data, drive, load, true) : balance_of_rotor(data, drive);
  const auto& [amplitude, periods, phase] = plant::kCoggingParameters;
  std::vector<std::vector<double>> starts;
  for (const Sinusoid& peak : strongest(balance)) {
    // The balance has the torque that the ripple takes away: -A sin(q x + p).
    const double size = std::hypot(peak.sine, peak.cosine) / scales.of(plant::Scale::kForce);
    starts.push_back(
        {within(amplitude, size), within(periods, peak.periods), within(phase, std::atan2(-peak.cosine, -peak.sine))});
  }
  return starts;
}

std::vector<std::vector<double>> starts_of_gravity(const JointData& data, const plant::ElectricParams& drive,
                                                   const plant::LoadParams& load, const plant::Scales& scales) {
  if (data.size() < 8 * kMargin) {
    return {};
  }
  const Balance balance = balance_of_load(data, drive, load, false);
  const Fit fit = fit_of(balance);
  // M sin(x - x_h) = M cos(x_h) sin(x) - M sin(x_h) cos(x)
  const Sinusoid weight = sinusoid_of(balance, fit.normal, fit.left, 1.0);
  const double size = std::hypot(weight.sine, weight.cosine) / scales.of(plant::Scale::kForce);
  return {{within(plant::kGravityParameters[0], size), std::atan2(-weight.cosine, weight.sine)}};
}

}  // namespace farrier::diagnosis
