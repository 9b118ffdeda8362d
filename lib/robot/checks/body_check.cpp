#include "robot/checks/body_check.hpp"

#include "robot/body_model.hpp"

namespace farrier::robot {
namespace {

void check_absent(const RobotFile& file, config::Problems& problems) {
  constexpr const char* kRemedy = "is for a robot with body.trunk: give that too, or leave it out";
  if (file.body) {
    const Body& body = *file.body;
    const auto absent = [&](const char* key, double value) {
      if (value != 0.0) {
        problems.push_back(body.place.problem(key, kRemedy));
      }
    };
    absent("foot_radius_m", body.foot_radius_m.value_or(0.0));
    absent("knee_radius_m", body.knee_radius_m);
    absent("joint_damping_Nms_rad", body.joint_damping_Nms_rad);
  }
  for (const auto& [name, leg] : file.legs) {
    if (!leg.hip_position_m.empty()) {
      problems.push_back(leg.place.problem("hip_position_m", kRemedy));
    }
  }
}

void check_leg_tree(const Leg& leg, config::Problems& problems) {
  if (leg.joints.size() != kJointsOfALeg) {
    problems.push_back(leg.joints_place.problem(
        "", "has " + std::to_string(leg.joints.size()) + " joints: a robot with body.trunk has HAA, HFE and KFE"));
  }
  if (leg.hip_position_m.empty()) {
    problems.push_back(leg.place.problem("hip_position_m", "is missing: a robot with body.trunk has it in each leg"));
  }
}

struct PlaceOfMass {
  const config::Place& place;
  const char* key;
};

void check_inertia(const body::RigidInertia& inertia, const PlaceOfMass& mass, const config::Place& place,
                   config::Problems& problems) {
  if (inertia.mass_kg == 0.0) {
    problems.push_back(mass.place.problem(mass.key, "is 0: a robot with body.trunk has a mass there"));
  } else if (const auto good = body::validate(inertia); !good) {
    problems.push_back(place.problem("inertia", good.error().message));
  }
}

void check_link(const body::RigidInertia& inertia, const Link& link, config::Problems& problems) {
  check_inertia(inertia, {link.place, "mass_kg"}, link.place, problems);
}

}  // namespace

config::Problems check_body(const RobotFile& file) {
  config::Problems problems;
  if (!file.body || !file.body->trunk) {
    check_absent(file, problems);
    return problems;
  }
  const Body& body = *file.body;
  if (!body.foot_radius_m) {
    problems.push_back(body.place.problem("foot_radius_m", "is missing: a robot with body.trunk has spheres as feet"));
  }
  check_inertia(trunk_inertia(body), {body.place, "trunk_mass_kg"}, body.trunk->place, problems);
  check_link(hip_inertia(body.hip), body.hip, problems);
  check_link(leg_link_inertia(body.upper_leg), body.upper_leg, problems);
  check_link(leg_link_inertia(body.lower_leg), body.lower_leg, problems);
  if (file.legs.size() > body::kMaxLegs) {
    problems.push_back(file.place.problem(
        "legs", "are " + std::to_string(file.legs.size()) + ": a robot with body.trunk has up to 6"));
  }
  for (const auto& [name, leg] : file.legs) {
    check_leg_tree(leg, problems);
  }
  return problems;
}

}  // namespace farrier::robot
