#include "locomotion/force_distribution.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace farrier::locomotion {
namespace {

// Columns (t1, t2, n): two tangents and the normal of the ground. The first tangent lies in the world's xz plane.
Eigen::Matrix3d contact_frame(const Eigen::Vector3d& normal) noexcept {
  Eigen::Matrix3d frame;
  frame.col(0) = (Eigen::Vector3d::UnitX() - normal.x() * normal).normalized();
  frame.col(1) = normal.cross(frame.col(0));
  frame.col(2) = normal;
  return frame;
}

// Edges of the pyramid |f_t1|, |f_t2| <= mu f_n, each with a normal component of one. Its sides face the tangents.
Eigen::Matrix<double, 3, kEdgesPerCone> pyramid_edges(const Eigen::Vector3d& normal, double friction) noexcept {
  Eigen::Matrix<double, 3, kEdgesPerCone> local;
  local << friction, friction, -friction, -friction,  //
      friction, -friction, friction, -friction,       //
      1.0, 1.0, 1.0, 1.0;
  return contact_frame(normal) * local;
}

}  // namespace

void ForceDistribution::distribute(const Wrench& wanted, const PerLeg<Contact>& contacts, int count,
                                   PerLeg<Eigen::Vector3d>& forces_N) noexcept {
  using Edges = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMaxEdges>;
  using Columns = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMaxEdges>;
  const int unknowns = kEdgesPerCone * count;
  Edges edges(3, unknowns);
  Columns weighted(6, unknowns);  // S A E
  Wrench rest = wanted;           // without the least forces
  for (int i = 0; i < count; ++i) {
    const auto own = pyramid_edges(contacts[i].normal, params_.friction);
    for (int k = 0; k < kEdgesPerCone; ++k) {
      const int column = kEdgesPerCone * i + k;
      edges.col(column) = own.col(k);
      weighted.col(column) << own.col(k), contacts[i].lever_m.cross(own.col(k));
    }
    const double least_N = std::min(params_.least_N, 0.5 * contacts[i].limit_N);
    forces_N[i] = least_N * contacts[i].normal;
    rest.head<3>() -= forces_N[i];
    rest.tail<3>() -= contacts[i].lever_m.cross(forces_N[i]);
    problem_.limit[i] = contacts[i].limit_N - least_N;
  }
  weighted = params_.weight.asDiagonal() * weighted;

  // H = (S A E)^T S A E + alpha E^T E per foot,  g = (S A E)^T S b
  problem_.cones = count;
  problem_.hessian.noalias() = weighted.transpose() * weighted;
  for (int i = 0; i < unknowns; i += kEdgesPerCone) {
    const auto own = edges.middleCols<kEdgesPerCone>(i);
    problem_.hessian.block<kEdgesPerCone, kEdgesPerCone>(i, i) += params_.force_weight * (own.transpose() * own);
  }
  problem_.gradient.noalias() = weighted.transpose() * params_.weight.cwiseProduct(rest);

  const ConeSolution& solution = solver_.solve(problem_);
  iterations_ = solution.iterations;
  unconverged_ += solution.converged ? 0 : 1;
  for (int i = 0; i < count; ++i) {
    forces_N[i] +=
        edges.middleCols<kEdgesPerCone>(kEdgesPerCone * i) * solution.x.segment<kEdgesPerCone>(kEdgesPerCone * i);
  }
}

}  // namespace farrier::locomotion
