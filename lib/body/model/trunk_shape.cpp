#include "body/model/trunk_shape.hpp"

namespace farrier::body {
namespace trunk_shape_parts {
namespace {

constexpr double kLeastSide_m = 1e-4;

/// The sides of the box of uniform density that has this mass and these moments of inertia: with I_x = m (y^2 + z^2) / 12
/// and so on, x^2 = 6 (I_y + I_z - I_x) / m.
Eigen::Vector3d sides_of(const RigidInertia& inertia) {
  const Eigen::Vector3d moments = inertia.tensor_kg_m2.diagonal();
  return (6.0 / inertia.mass_kg * (Eigen::Vector3d::Constant(moments.sum()) - 2.0 * moments)).cwiseMax(0.0).cwiseSqrt();
}

}  // namespace
}  // namespace trunk_shape_parts

TrunkBox shown_trunk(const BodyModel& model) {
  Eigen::AlignedBox3d hinges;
  for (const LegModel& leg : model.legs) {
    hinges.extend(leg.links.front().hinge_m);
  }
  const Eigen::Vector3d spanned = hinges.sizes();
  const Eigen::Vector3d size =
      (spanned.array() > trunk_shape_parts::kLeastSide_m).select(spanned, trunk_shape_parts::sides_of(model.trunk));
  return {.centre_m = hinges.center(), .half_extents_m = 0.5 * size};
}

}  // namespace farrier::body
