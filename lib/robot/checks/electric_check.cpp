#include "robot/checks/electric_check.hpp"

#include <iomanip>
#include <sstream>

#include "robot/derive.hpp"

namespace farrier::robot {
namespace {

const char* name_of(control::Kind kind) noexcept {
  for (const auto& known : kControllerKinds) {
    if (known.value == kind) {
      return known.name;
    }
  }
  return "";
}

void check_joint(const RobotFile& file, const JointTemplate& joint, config::Problems& problems) {
  const auto refuse = [&](const char* key, const std::string& message) {
    problems.push_back(joint.place.problem(key, message));
  };
  const Load* load = config::find(file.loads, joint.load);
  if (load != nullptr && !load->rotary) {
    refuse("load", joint.load + " is for a hydraulic joint: an electric one takes one with rotary");
  }
  const LinkageSection* linkage = config::find(file.linkages, joint.linkage);
  if (linkage != nullptr && linkage->triangle) {
    refuse("linkage", joint.linkage + " is for a cylinder: an electric joint takes a direct one");
  }
  const Controller* controller = config::find(file.controllers, joint.controller);
  if (controller != nullptr && controller->kind != control::Kind::kLqr && controller->kind != control::Kind::kPid) {
    refuse("controller", joint.controller + " is of kind " + name_of(controller->kind) +
                             ", which inverts the flow of oil: an electric joint takes lqr or pid");
  }
  const EstimatorSection* estimator = config::find(file.estimators, joint.estimator);
  if (estimator != nullptr && !estimator->params.regresses()) {
    refuse("estimator", joint.estimator +
                            " estimates the physics of a hydraulic joint: an electric one takes another "
                            "method");
  }
}

std::string rounded(double value) {
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

void check_spring(const ElectricActuator& actuator, config::Problems& problems) {
  if (actuator.by_limits() || !actuator.spring_stiffness_Nm_rad || spring_is_rigid(actuator)) {
    return;
  }
  const auto [stiffest, softest_rigid] = spring_limits(actuator);
  if (*actuator.spring_stiffness_Nm_rad > stiffest) {
    problems.push_back(actuator.place.problem(
        "spring_stiffness_Nm_rad", rounded(*actuator.spring_stiffness_Nm_rad) +
                                       " lets the rotor oscillate on the spring: give at most " + rounded(stiffest) +
                                       ", or leave the key out for a drive without a spring; from " +
                                       rounded(softest_rigid) + " on the drive counts as rigid"));
  }
}

/// `name` is that of a joint of a leg or of a section of joints.
bool is_electric(const RobotFile& file, const std::string& name) {
  const JointTemplate* joint = config::find(file.joints, name);
  for (const auto& [leg_name, leg] : file.legs) {
    const std::string* from = config::find(leg.joints, name);
    joint = from != nullptr ? config::find(file.joints, *from) : joint;
  }
  return joint != nullptr && electric_actuator_of(file, *joint) != nullptr;
}

}  // namespace

const ElectricActuator* electric_actuator_of(const RobotFile& file, const JointTemplate& joint) {
  return config::find(file.electric_actuators, joint.actuator);
}

double stroke_of(const RobotFile& file, const JointTemplate& joint) {
  if (const ElectricActuator* electric = electric_actuator_of(file, joint)) {
    return electric->travel_rad;
  }
  const Actuator& actuator = *config::find(file.actuators, joint.actuator);
  return actuator.cylinder ? actuator.cylinder->stroke_m : actuator.rotary_motor->travel_rad;
}

config::Problems check_electric(const RobotFile& file) {
  config::Problems problems;
  if (!file.actuators.empty() && !file.supply) {
    problems.push_back(file.place.problem("supply", "is missing: hydraulic actuators need it"));
  }
  for (const auto& [name, actuator] : file.electric_actuators) {
    check_spring(actuator, problems);
    if (config::find(file.actuators, name) != nullptr) {
      problems.push_back(actuator.place.problem("", "has the name of a hydraulic actuator: rename one"));
    }
  }
  for (const auto& [name, joint] : file.joints) {
    if (electric_actuator_of(file, joint) != nullptr) {
      check_joint(file, joint, problems);
    }
  }
  for (const auto& [name, effects] : file.effects) {
    if (is_electric(file, name)) {
      problems.push_back(effects.place.problem("", "is an electric joint: effects are those of hydraulic ones"));
    }
  }
  return problems;
}

}  // namespace farrier::robot
