#include "locomotion/cone_least_squares.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace farrier::locomotion {
namespace {

// A slope counts as zero below this part of the largest entry of g. Rounding is three orders smaller.
constexpr double kRelativeTolerance = 1e-11;

int cone_of(int edge) noexcept { return edge / kEdgesPerCone; }

}  // namespace

int ConeLeastSquares::passive_edges_of(int cone) const noexcept {
  int edges = 0;
  for (int i = 0; i < count_; ++i) {
    edges += cone_of(passive_[i]) == cone ? 1 : 0;
  }
  return edges;
}

void ConeLeastSquares::remove(int position) noexcept {
  solution_.x[passive_[position]] = 0.0;
  std::copy(passive_.begin() + position + 1, passive_.begin() + count_, passive_.begin() + position);
  --count_;
}

// Slopes of all edges, and the multiplier of a reached limit: the common slope of the cone's passive edges.
void ConeLeastSquares::multipliers() noexcept {
  slope_ = problem_->gradient;
  slope_.noalias() -= problem_->hessian * solution_.x;
  PerLeg<int> edges{};
  solution_.limit_force.fill(0.0);
  for (int i = 0; i < count_; ++i) {
    const int cone = cone_of(passive_[i]);
    if (limited_[cone]) {
      solution_.limit_force[cone] += slope_[passive_[i]];
      ++edges[cone];
    }
  }
  for (int cone = 0; cone < problem_->cones; ++cone) {
    if (edges[cone] > 0) {
      solution_.limit_force[cone] /= edges[cone];
    }
  }
}

// Releases the constraint along which the objective falls fastest. Returns false at the optimum.
bool ConeLeastSquares::add_most_wanted() noexcept {
  multipliers();
  double best = tolerance_;
  int edge = -1;
  int released = -1;
  for (int cone = 0; cone < problem_->cones; ++cone) {
    if (limited_[cone] && -solution_.limit_force[cone] > best) {
      best = -solution_.limit_force[cone];
      released = cone;
    }
    // A fourth edge of a cone depends on the other three.
    if (passive_edges_of(cone) == kEdgesPerCone - 1) {
      continue;
    }
    for (int e = kEdgesPerCone * cone; e < kEdgesPerCone * (cone + 1); ++e) {
      const bool is_passive = std::find(passive_.begin(), passive_.begin() + count_, e) != passive_.begin() + count_;
      const double wanted = slope_[e] - solution_.limit_force[cone];
      if (!is_passive && wanted > best) {
        best = wanted;
        edge = e;
        released = -1;
      }
    }
  }
  if (released >= 0) {
    limited_[released] = false;
    solution_.limit_force[released] = 0.0;
    return true;
  }
  if (edge >= 0) {
    passive_[count_++] = edge;
  }
  return edge >= 0;
}

// Minimum over the passive edges with reached limits as equalities B z = c:
//   z = H_p^-1 (g_p - B^T m),   (B H_p^-1 B^T) m = B H_p^-1 g_p - c
ConeLeastSquares::Passive ConeLeastSquares::solve_with_active_limits() noexcept {
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxPassive, kMaxPassive>;
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxPassive, kMaxLegs>;
  using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxLegs, kMaxLegs>;
  using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxLegs, 1>;
  ++solution_.iterations;
  Square h(count_, count_);
  Passive z(count_);
  for (int i = 0; i < count_; ++i) {
    z[i] = problem_->gradient[passive_[i]];
    for (int j = 0; j < count_; ++j) {
      h(i, j) = problem_->hessian(passive_[i], passive_[j]);
    }
  }
  const Eigen::LLT<Square> factor(h);
  factor.solveInPlace(z);
  const auto limits = static_cast<int>(std::count(limited_.begin(), limited_.begin() + problem_->cones, true));
  if (limits == 0) {
    return z;
  }
  Columns b = Columns::Zero(count_, limits);
  SmallVector c(limits);
  for (int cone = 0, column = 0; cone < problem_->cones; ++cone) {
    if (limited_[cone]) {
      for (int i = 0; i < count_; ++i) {
        b(i, column) = cone_of(passive_[i]) == cone ? 1.0 : 0.0;
      }
      c[column++] = problem_->limit[cone];
    }
  }
  Columns hb = b;
  factor.solveInPlace(hb);
  const Small schur = b.transpose() * hb;
  const SmallVector m = Eigen::LLT<Small>(schur).solve(b.transpose() * z - c);
  z.noalias() -= hb * m;
  return z;
}

// Largest part of the way to `target` that stays feasible, and the edge or cone that blocks there.
double ConeLeastSquares::step_to_boundary(const Passive& target, int& edge, int& cone) const noexcept {
  double step = 1.0;
  PerLeg<double> change{};
  for (int i = 0; i < count_; ++i) {
    const double from = solution_.x[passive_[i]];
    change[cone_of(passive_[i])] += target[i] - from;
    if (target[i] < 0.0 && from <= step * (from - target[i])) {
      step = from / (from - target[i]);
      edge = i;
    }
  }
  for (int i = 0; i < problem_->cones; ++i) {
    const double room = problem_->limit[i] - sum_of(i);
    if (!limited_[i] && change[i] > room && std::max(0.0, room) < step * change[i]) {
      step = std::max(0.0, room) / change[i];
      cone = i;
      edge = -1;
    }
  }
  return step;
}

// Inner loop of NNLS: moves to the minimum over the passive edges, and drops those that would become negative.
void ConeLeastSquares::descend() noexcept {
  while (count_ > 0 && solution_.iterations < kMaxConeIterations) {
    const Passive target = solve_with_active_limits();
    int edge = -1;
    int cone = -1;
    const double step = step_to_boundary(target, edge, cone);
    for (int i = 0; i < count_; ++i) {
      double& x = solution_.x[passive_[i]];
      x = std::max(0.0, edge < 0 && cone < 0 ? target[i] : x + step * (target[i] - x));
    }
    if (edge >= 0) {
      remove(edge);
    } else if (cone >= 0) {
      limited_[cone] = true;
    } else {
      return;
    }
  }
}

const ConeSolution& ConeLeastSquares::solve(const ConeProblem& problem) noexcept {
  problem_ = &problem;
  const int edges = kEdgesPerCone * problem.cones;
  solution_.x = EdgeVector::Zero(edges);
  solution_.limit_force.fill(0.0);
  solution_.iterations = 0;
  solution_.converged = true;
  count_ = 0;
  limited_.fill(false);
  if (edges == 0) {
    return solution_;
  }
  tolerance_ = kRelativeTolerance * problem.gradient.cwiseAbs().maxCoeff();
  while (add_most_wanted()) {
    if (solution_.iterations >= kMaxConeIterations) {
      solution_.converged = false;
      break;
    }
    descend();
  }
  return solution_;
}

}  // namespace farrier::locomotion
