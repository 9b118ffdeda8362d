#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "diagnosis/data/joint_data.hpp"

namespace farrier::diagnosis {

/// A balance of forces at samples of a recording, of which linear terms leave something unexplained that swings with the
/// position.
struct Balance {
  Eigen::VectorXd position;  ///< m or rad
  Eigen::VectorXd force;     ///< N or Nm
  Eigen::MatrixXd terms;     ///< a column per linear term
  Eigen::VectorXd along;     ///< factor of the sinusoid at each sample; empty: 1
};

/// Samples of a recording for a balance: every other in which the load is the modelled one, away from the ends.
std::vector<std::size_t> balance_samples(const JointData& data);

/// True if a recording is long enough for a balance.
bool has_balance(const JointData& data) noexcept;

/// A balance over `samples`, to be filled in.
Balance balance_over(const std::vector<std::size_t>& samples, Eigen::Index terms);

/// A sinusoid b sin(q x) + c cos(q x) beside the terms: its numbers, and the squares that it explains.
struct Sinusoid {
  double periods;  ///< q, 1/m or 1/rad
  double sine, cosine, explained;
};

/// The least squares of a balance with a sinusoid of `periods`.
Sinusoid sinusoid_of(const Balance& balance, double periods);

/// Coefficients of the linear terms alone, by least squares.
Eigen::VectorXd linear_terms(const Balance& balance);

/// Coefficients of the linear terms beside a sinusoid.
Eigen::VectorXd terms_beside(const Balance& balance, const Sinusoid& sinusoid);

/// Values of q that are tried: from `low` up to below `high`.
struct PeriodGrid {
  double low, high, step;
};

/// Step of q over the recorded positions at which a sinusoid becomes a different one; infinite without motion.
double telling_step(const Balance& balance);

/// The strongest peaks over the grid, at most `most`, the strongest first; none without motion.
std::vector<Sinusoid> strongest_sinusoids(const Balance& balance, const PeriodGrid& grid, std::size_t most);

}  // namespace farrier::diagnosis
