#include "robot/checks/locomotion_check.hpp"

#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace farrier::robot {
namespace {

using FoldedAngle = std::pair<const char*, double>;

void check_folded(const RobotFile& file, const FoldedAngle& folded, const std::string& joint_name,
                  config::Problems& problems) {
  const JointTemplate& joint = *config::find(file.joints, joint_name);
  if (folded.second < joint.angle_min_rad || folded.second > joint.angle_max_rad) {
    problems.push_back(file.locomotion->place.problem(
        folded.first, "is " + config::number_text(folded.second) + ", but joint " + joint_name + " goes from " +
                          config::number_text(joint.angle_min_rad) + " to " + config::number_text(joint.angle_max_rad) +
                          ": give an angle between"));
  }
}

// Leg lengths of trunks that stand level on feet beside their hips.
void check_reach(const RobotFile& file, config::Problems& problems) {
  const LocomotionSection& section = *file.locomotion;
  const Body& body = *file.body;
  const double whole_m = body.hip_offset_m + body.upper_leg_m + body.lower_leg_m;
  const double longest_m = section.params.leg.longest_leg_m;
  if (longest_m > whole_m) {
    problems.push_back(section.place.problem("leg", "has longest_leg_m " + config::number_text(longest_m) +
                                                        ", but a straight leg has " + config::number_text(whole_m) +
                                                        ": give less"));
  }
  for (const auto& [name, leg] : file.legs) {
    if (leg.hip_position_m.size() != 3 || !body.foot_radius_m) {
      continue;
    }
    const double down_m = section.params.reference.largest_height_m + leg.hip_position_m[2] - *body.foot_radius_m;
    if (std::hypot(down_m, section.params.foothold.wider_m) > longest_m) {
      problems.push_back(section.place.problem(
          "reference", "has largest_height_m " + config::number_text(section.params.reference.largest_height_m) +
                           ", at which the foot of leg " + name +
                           " does not reach the ground: give less, or a larger "
                           "longest_leg_m"));
    }
  }
}

// A touchdown that may only be felt after its plan is never felt.
void check_felt_touchdown(const RobotFile& file, config::Problems& problems) {
  const LocomotionSection& section = *file.locomotion;
  const locomotion::FeltTouchdownParams& felt = section.params.felt_touchdown;
  const double swing_s = (1.0 - file.gait.duty) / file.gait.frequency_Hz - file.safety.params.stance_lead_s;
  if (felt.on && felt.least_swing_s + felt.debounce_s >= swing_s) {
    problems.push_back(section.place.problem(
        "felt_touchdown", "has least_swing_s " + config::number_text(felt.least_swing_s) + " and debounce_s " +
                              config::number_text(felt.debounce_s) + ", but the gains of swing act for " +
                              config::number_text(swing_s) + " s: give less, or on: false"));
  }
}

}  // namespace

config::Problems check_locomotion(const RobotFile& file) {
  config::Problems problems;
  if (!file.locomotion) {
    return problems;
  }
  const LocomotionSection& section = *file.locomotion;
  if (!file.body || !file.body->trunk) {
    problems.push_back(section.place.problem("", "is for a robot with body.trunk: give that too, or leave it out"));
    return problems;
  }
  check_reach(file, problems);
  check_felt_touchdown(file, problems);
  const std::array<FoldedAngle, kJointsOfALeg> folded{FoldedAngle{"folded_haa_rad", section.folded_haa_rad},
                                                      {"folded_hfe_rad", section.folded_hfe_rad},
                                                      {"folded_kfe_rad", section.folded_kfe_rad}};
  std::set<std::pair<std::size_t, std::string>> told;
  for (const auto& [name, leg] : file.legs) {
    for (std::size_t i = 0; i < leg.joints.size() && i < kJointsOfALeg; ++i) {
      if (told.emplace(i, leg.joints[i].second).second) {
        check_folded(file, folded[i], leg.joints[i].second, problems);
      }
    }
  }
  return problems;
}

}  // namespace farrier::robot
