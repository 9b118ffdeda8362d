#include "robot/locomotion_params.hpp"

namespace farrier::robot {
namespace {

locomotion::LegMount mount_of(const RobotFile& file, const Leg& leg) {
  const LocomotionSection& section = *file.locomotion;
  const std::array<double, kJointsOfALeg> folded{section.folded_haa_rad, section.folded_hfe_rad,
                                                 section.folded_kfe_rad};
  locomotion::LegMount mount{.hip_m = {leg.hip_position_m[0], leg.hip_position_m[1], leg.hip_position_m[2]},
                             .outward = leg.left ? 1.0 : -1.0};
  for (std::size_t i = 0; i < kJointsOfALeg; ++i) {
    const JointTemplate& joint = *config::find(file.joints, leg.joints[i].second);
    mount.folded_rad[static_cast<Eigen::Index>(i)] = joint.mirrored_in_front && leg.front ? -folded[i] : folded[i];
  }
  return mount;
}

}  // namespace

std::optional<locomotion::LocomotionParams> make_locomotion_params(const RobotFile& file) {
  if (!file.locomotion) {
    return std::nullopt;
  }
  locomotion::LocomotionParams params = file.locomotion->params;
  params.estimator.foot_radius_m = *file.body->foot_radius_m;
  params.felt_touchdown.stance_lead_s = file.safety.params.stance_lead_s;
  for (std::size_t leg = 0; leg < file.legs.size(); ++leg) {
    params.mounts[leg] = mount_of(file, file.legs[leg].second);
  }
  return params;
}

gait::RobotPlan locomotion_plan(const gait::RobotPlan& plan) {
  gait::RobotPlan without_jitter = plan;
  without_jitter.gait.touchdown_jitter_s = 0.0;
  return without_jitter;
}

}  // namespace farrier::robot
