#include "body/model/body_model.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace farrier::body {
namespace {

// Rounding of data with at least six digits, relative to the largest element.
constexpr double kTensorRounding = 1e-9;
constexpr double kAxisRounding = 1e-6;
// Below this the physics engine takes a body for one without inertia.
constexpr double kLeastMass_kg = 1e-6;
constexpr double kLeastMoment_kg_m2 = 1e-9;

constexpr std::array<const char*, kJointsPerLeg> kLinkNames{"first link", "second link", "third link"};

double least_eigenvalue(const Eigen::Matrix3d& symmetric) noexcept {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(symmetric, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

Result<Done> named(const std::string& body, const Result<Done>& checked) {
  return checked ? checked : Error{body + " " + checked.error().message};
}

Result<Done> check_link(const Link& link, const std::string& body) {
  if (!link.hinge_m.allFinite()) {
    return Error{body + " has a hinge at a position that is not finite"};
  }
  if (!(std::abs(link.axis.norm() - 1.0) <= kAxisRounding)) {
    return Error{body + " has an axis that is not of unit length"};
  }
  if (!(link.armature_kg_m2 >= 0.0) || !(link.damping_Nms_rad >= 0.0)) {
    return Error{body + " has a negative armature or damping: give zero for none"};
  }
  if (link.stops && !(link.stops->least_rad < link.stops->largest_rad)) {
    return Error{body + " has stops that leave no angle between them: give the least angle first"};
  }
  return named(body, validate(link.inertia));
}

Result<Done> check_leg(const LegModel& leg) {
  for (std::size_t i = 0; i < leg.links.size(); ++i) {
    FARRIER_TRY(check_link(leg.links[i], "leg " + leg.name + ": the " + kLinkNames[i]));
  }
  if (!leg.foot_m.allFinite()) {
    return Error{"leg " + leg.name + ": the foot is at a position that is not finite"};
  }
  if (!(leg.foot_radius_m > 0.0) || !std::isfinite(leg.foot_radius_m)) {
    return Error{"leg " + leg.name + ": the foot has no size: give the radius of its sphere in m, above zero"};
  }
  if (!(leg.knee_radius_m >= 0.0) || !std::isfinite(leg.knee_radius_m)) {
    return Error{"leg " + leg.name + ": the knee has a negative radius: give zero for none"};
  }
  return Done{};
}

}  // namespace

Result<Done> validate(const RigidInertia& inertia) {
  const Eigen::Matrix3d& tensor = inertia.tensor_kg_m2;
  if (!(inertia.mass_kg >= kLeastMass_kg) || !std::isfinite(inertia.mass_kg)) {
    return Error{"has no mass: give its mass in kg, above zero"};
  }
  if (!inertia.com_m.allFinite() || !tensor.allFinite()) {
    return Error{"has a centre of mass or a tensor that is not finite"};
  }
  if (!tensor.isApprox(tensor.transpose(), kTensorRounding)) {
    return Error{"has a tensor that is not symmetric"};
  }
  if (!is_possible_tensor(tensor)) {
    return Error{std::string("has a tensor that ") + kImpossibleTensor};
  }
  if (!(least_eigenvalue(tensor) >= kLeastMoment_kg_m2)) {
    return Error{"has a tensor that is not positive definite: give every principal moment, above zero"};
  }
  return Done{};
}

Result<Done> validate(const BodyModel& model) {
  if (model.legs.empty() || model.legs.size() > kMaxLegs) {
    return Error{"the body has " + std::to_string(model.legs.size()) + " legs: give 1 to " + std::to_string(kMaxLegs)};
  }
  if (!(model.gravity_m_s2 >= 0.0) || !std::isfinite(model.gravity_m_s2)) {
    return Error{"gravity is negative or not finite: give its magnitude in m/s^2"};
  }
  FARRIER_TRY(named("the trunk", validate(model.trunk)));
  if (model.box && !(model.box->centre_m.allFinite() && model.box->half_extents_m.allFinite() &&
                     model.box->half_extents_m.minCoeff() > 0.0)) {
    return Error{"the trunk has a box without volume: give three half extents in m, above zero"};
  }
  for (const LegModel& leg : model.legs) {
    FARRIER_TRY(check_leg(leg));
  }
  return Done{};
}

double total_mass_kg(const BodyModel& model) noexcept {
  double sum = model.trunk.mass_kg;
  for (const LegModel& leg : model.legs) {
    for (const Link& link : leg.links) {
      sum += link.inertia.mass_kg;
    }
  }
  return sum;
}

bool is_possible_tensor(const Eigen::Matrix3d& tensor_kg_m2) noexcept {
  if (!tensor_kg_m2.allFinite()) {
    return false;
  }
  const Eigen::Matrix3d second_moments = 0.5 * tensor_kg_m2.trace() * Eigen::Matrix3d::Identity() - tensor_kg_m2;
  return least_eigenvalue(second_moments) >= -kTensorRounding * tensor_kg_m2.cwiseAbs().maxCoeff();
}

PrincipalInertia principal_inertia(const Eigen::Matrix3d& tensor_kg_m2) noexcept {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor_kg_m2);
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0.0) {
    axes.col(2) *= -1.0;
  }
  return {solver.eigenvalues(), Eigen::Quaterniond(axes).normalized()};
}

}  // namespace farrier::body
