#include "diagnosis/model/sinusoid_balance.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <Eigen/Cholesky>

namespace farrier::diagnosis {
namespace {

constexpr std::size_t kEvery = 2;
constexpr std::size_t kMargin = 20;  ///< from the ends, where the smoothed motion settles
constexpr double kGridShare = 0.3;   ///< of the distance at which a sinusoid over the recorded positions is another

/// The linear terms alone: their normal matrix, their coefficients, and the forces that they leave.
struct TermsFit {
  Eigen::LLT<Eigen::MatrixXd> normal;
  Eigen::VectorXd terms;
  Eigen::VectorXd left;
};

TermsFit fit_of(const Balance& balance) {
  Eigen::MatrixXd square = balance.terms.transpose() * balance.terms;
  square.diagonal() *= 1.0 + 1e-9;
  square.diagonal().array() += 1e-300;
  TermsFit fit{square.llt(), {}, {}};
  fit.terms = fit.normal.solve(balance.terms.transpose() * balance.force);
  fit.left = balance.force - balance.terms * fit.terms;
  return fit;
}

Eigen::MatrixXd wave_of(const Balance& balance, double periods) {
  Eigen::MatrixXd wave(balance.position.size(), 2);
  wave.col(0) = (periods * balance.position.array()).sin();
  wave.col(1) = (periods * balance.position.array()).cos();
  if (balance.along.size() > 0) {
    wave.array().colwise() *= balance.along.array();
  }
  return wave;
}

Sinusoid sinusoid_of(const Balance& balance, const TermsFit& fit, double periods) {
  const Eigen::MatrixXd wave = wave_of(balance, periods);
  const Eigen::MatrixXd cross = balance.terms.transpose() * wave;
  Eigen::Matrix2d own = wave.transpose() * wave - cross.transpose() * fit.normal.solve(cross);
  own.diagonal().array() += 1e-9 * static_cast<double>(balance.position.size());
  const Eigen::Vector2d along = wave.transpose() * fit.left;
  const Eigen::Vector2d amplitudes = own.llt().solve(along);
  return {periods, amplitudes[0], amplitudes[1], amplitudes.dot(along)};
}

}  // namespace

std::vector<std::size_t> balance_samples(const JointData& data) {
  std::vector<std::size_t> chosen;
  for (std::size_t k = kMargin; k + kMargin < data.size(); k += kEvery) {
    if (data.swing.empty() || data.swing[k] != 0) {
      chosen.push_back(k);
    }
  }
  return chosen;
}

bool has_balance(const JointData& data) noexcept { return data.size() >= 8 * kMargin; }

Balance balance_over(const std::vector<std::size_t>& samples, Eigen::Index terms) {
  const auto rows = static_cast<Eigen::Index>(samples.size());
  return {Eigen::VectorXd(rows), Eigen::VectorXd(rows), Eigen::MatrixXd(rows, terms), {}};
}

Sinusoid sinusoid_of(const Balance& balance, double periods) { return sinusoid_of(balance, fit_of(balance), periods); }

Eigen::VectorXd linear_terms(const Balance& balance) { return fit_of(balance).terms; }

Eigen::VectorXd terms_beside(const Balance& balance, const Sinusoid& sinusoid) {
  Balance rest = balance;
  rest.force -= wave_of(balance, sinusoid.periods) * Eigen::Vector2d(sinusoid.sine, sinusoid.cosine);
  return linear_terms(rest);
}

double telling_step(const Balance& balance) {
  if (balance.position.size() == 0) {
    return std::numeric_limits<double>::infinity();
  }
  const double range = balance.position.maxCoeff() - balance.position.minCoeff();
  return kGridShare * 2.0 * std::numbers::pi / range;
}

std::vector<Sinusoid> strongest_sinusoids(const Balance& balance, const PeriodGrid& grid, std::size_t most) {
  const TermsFit fit = fit_of(balance);
  std::vector<Sinusoid> all;
  for (double q = grid.low; q < grid.high; q += grid.step) {
    all.push_back(sinusoid_of(balance, fit, q));
  }
  std::vector<Sinusoid> peaks;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool rises = i == 0 || all[i].explained >= all[i - 1].explained;
    const bool falls = i + 1 == all.size() || all[i].explained > all[i + 1].explained;
    if (rises && falls) {
      peaks.push_back(all[i]);
    }
  }
  std::ranges::sort(peaks, std::greater{}, &Sinusoid::explained);
  peaks.resize(std::min(peaks.size(), most));
  return peaks;
}

}  // namespace farrier::diagnosis
