#include "locomotion/foothold.hpp"

#include <Eigen/Geometry>

namespace farrier::locomotion {

Eigen::Vector3d foothold(const FootholdParams& params, const FootholdInput& in) noexcept {
  const Eigen::Vector3d turn = in.wanted_yaw_rate_rad_s * Eigen::Vector3d::UnitZ().cross(in.from_trunk_m);
  Eigen::Vector3d step = 0.5 * in.stance_s * (in.wanted_velocity_m_s + turn) +
                         params.velocity_gain_s * (in.velocity_m_s - in.wanted_velocity_m_s);
  step = step.cwiseMax(-params.reach_m).cwiseMin(params.reach_m);
  Eigen::Vector3d place = in.hip_m + in.rest_s * (in.velocity_m_s + turn) + step;
  place.z() = in.hip_m.z();
  return place;
}

}  // namespace farrier::locomotion
