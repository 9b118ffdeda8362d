#include "diagnosis/judge/box_minimum.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

namespace farrier::diagnosis {
namespace {

enum class Held { kFree, kLow, kHigh };

/// Changes of the set of held numbers, per number. Each lowers the function, so that more are a matter of rounding.
constexpr Eigen::Index kMostChanges = 4;

/// Slope inwards at a bound that counts as none, over the largest of all.
constexpr double kFlat = 1e-10;

std::vector<Eigen::Index> free_ones(const std::vector<Held>& held) {
  std::vector<Eigen::Index> free;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i] == Held::kFree) {
      free.push_back(static_cast<Eigen::Index>(i));
    }
  }
  return free;
}

}  // namespace

Eigen::VectorXd box_minimum(const Eigen::MatrixXd& normal, const Eigen::VectorXd& descent, const Eigen::VectorXd& low,
                            const Eigen::VectorXd& high) {
  const Eigen::Index n = descent.size();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  std::vector<Held> held(static_cast<std::size_t>(n), Held::kFree);
  for (Eigen::Index change = 0; change < kMostChanges * n; ++change) {
    const std::vector<Eigen::Index> free = free_ones(held);
    Eigen::VectorXd towards = Eigen::VectorXd::Zero(n);
    if (!free.empty()) {
      const Eigen::VectorXd rest = descent - normal * x;
      const Eigen::MatrixXd part = normal(free, free);
      const Eigen::VectorXd right = rest(free);
      const Eigen::VectorXd solved = part.ldlt().solve(right);
      towards(free) = solved;
    }
    double share = 1.0;
    Eigen::Index first = -1;
    for (const Eigen::Index i : free) {
      const double room = (towards[i] < 0.0 ? low[i] : high[i]) - x[i];
      if (std::abs(towards[i]) * share > std::abs(room)) {
        share = room / towards[i];
        first = i;
      }
    }
    x += share * towards;
    if (first >= 0) {
      const bool falls = towards[first] < 0.0;
      held[static_cast<std::size_t>(first)] = falls ? Held::kLow : Held::kHigh;
      x[first] = falls ? low[first] : high[first];
      continue;
    }
    const Eigen::VectorXd slope = descent - normal * x;
    double steepest = kFlat * descent.lpNorm<Eigen::Infinity>();
    std::size_t released = held.size();
    for (std::size_t i = 0; i < held.size(); ++i) {
      const double along = slope[static_cast<Eigen::Index>(i)];
      const double inwards = held[i] == Held::kLow ? along : held[i] == Held::kHigh ? -along : 0.0;
      if (inwards > steepest) {
        steepest = inwards;
        released = i;
      }
    }
    if (released == held.size()) {
      break;
    }
    held[released] = Held::kFree;
  }
  return x.cwiseMax(low).cwiseMin(high);
}

}  // namespace farrier::diagnosis
