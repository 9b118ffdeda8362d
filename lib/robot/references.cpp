#include "robot/references.hpp"

#include <map>
#include <utility>
#include <vector>

#include "config/suggest.hpp"
#include "robot/checks/electric_check.hpp"

namespace farrier::robot {
namespace {

constexpr std::size_t kMostJoints = 64;

class ReferenceCheck {
 public:
  explicit ReferenceCheck(const RobotFile& file) : file_(file) {}

  config::Problems run() {
    for (const auto& [name, actuator] : file_.actuators) {
      check_actuator(actuator);
    }
    for (const auto& [name, load] : file_.loads) {
      check_load(load);
    }
    for (const auto& [name, joint] : file_.joints) {
      check_joint(joint);
    }
    if (file_.locomotion && !file_.locomotion->controller.empty()) {
      resolve(file_.controllers, "controllers", file_.locomotion->controller, file_.locomotion->place, "controller");
    }
    if (file_.locomotion && !file_.locomotion->joint_estimator.empty()) {
      resolve(file_.estimators, "estimators", file_.locomotion->joint_estimator, file_.locomotion->place,
              "joint_estimator");
    }
    for (const auto& [name, leg] : file_.legs) {
      check_leg(name, leg);
    }
    for (const auto* sections : {&file_.effects, &file_.effects_on_ground}) {
      for (const auto& [name, effects] : *sections) {
        check_effects(name, effects);
      }
    }
    if (joints_.size() > kMostJoints) {
      problems_.push_back(file_.place.problem("legs", "have more than 64 joints together"));
    }
    for (config::Problem& misfit : check_electric(file_)) {
      problems_.push_back(std::move(misfit));
    }
    return std::move(problems_);
  }

 private:
  // The section of that name; when there is none, a problem that lists those there are.
  template <class T>
  const T* resolve(const config::Named<T>& sections, const char* title, const std::string& name,
                   const config::Place& place, const std::string& key) {
    const T* found = config::find(sections, name);
    if (found == nullptr) {
      std::string message = name + " is not one of " + title + ":";
      for (const auto& section : sections) {
        message += (section.first == sections.front().first ? " " : ", ") + section.first;
      }
      problems_.push_back(place.problem(key, message));
    }
    return found;
  }

  void check_actuator(const Actuator& actuator) {
    resolve(file_.valves, "valves", actuator.valve, actuator.place, "valve");
    if (!actuator.rotary_motor) {
      return;
    }
    const RotaryMotor& motor = *actuator.rotary_motor;
    const Actuator* model = resolve(file_.actuators, "actuators", motor.like_cylinder, motor.place, "like_cylinder");
    if (model != nullptr && !model->cylinder) {
      problems_.push_back(motor.place.problem("like_cylinder", motor.like_cylinder + " is not a cylinder"));
    }
    for (const std::string& name : motor.lever_joints) {
      const JointTemplate* joint = resolve(file_.joints, "joints", name, motor.place, "lever_joints");
      const Actuator* drive = joint != nullptr ? config::find(file_.actuators, joint->actuator) : nullptr;
      const bool electric = joint != nullptr && electric_actuator_of(file_, *joint) != nullptr;
      if (electric || (drive != nullptr && !drive->cylinder)) {
        problems_.push_back(motor.place.problem("lever_joints", name + " has no cylinder"));
      }
    }
  }

  void check_load(const Load& load) {
    if (!load.leg_about_haa) {
      return;
    }
    if (!file_.body) {
      problems_.push_back(load.place.problem("leg_about_haa", "needs the group body to compute the leg's inertia"));
    }
    const LegLoad& leg = *load.leg_about_haa;
    const Load* model = resolve(file_.loads, "loads", leg.damping_like, leg.place, "damping_like");
    if (model != nullptr && !model->swing) {
      problems_.push_back(leg.place.problem("damping_like", leg.damping_like + " has no swing load"));
    }
  }

  void check_joint(const JointTemplate& joint) {
    const bool electric = electric_actuator_of(file_, joint) != nullptr;
    const Actuator* actuator =
        electric ? nullptr : resolve(file_.actuators, "actuators", joint.actuator, joint.place, "actuator");
    const LinkageSection* linkage = resolve(file_.linkages, "linkages", joint.linkage, joint.place, "linkage");
    const Load* load = resolve(file_.loads, "loads", joint.load, joint.place, "load");
    resolve(file_.controllers, "controllers", joint.controller, joint.place, "controller");
    resolve(file_.estimators, "estimators", joint.estimator, joint.place, "estimator");
    if (actuator == nullptr) {
      return;
    }
    const bool rotary = actuator->rotary_motor.has_value();
    if (load != nullptr && load->rotary) {
      problems_.push_back(joint.place.problem("load", joint.load +
                                                          " is for an electric joint: a hydraulic one takes one with " +
                                                          (rotary ? "leg_about_haa" : "swing and stance")));
    } else if (load != nullptr && load->leg_about_haa.has_value() != rotary) {
      problems_.push_back(joint.place.problem(
          "load", joint.load + (rotary ? " is for a cylinder: a rotary motor takes one with leg_about_haa"
                                       : " is for a rotary motor: a cylinder takes one with swing and stance")));
    }
    if (linkage != nullptr && rotary && linkage->triangle) {
      problems_.push_back(
          joint.place.problem("linkage", joint.linkage + " is for a cylinder: a motor takes a direct one"));
    }
  }

  void check_leg(const std::string& leg_name, const Leg& leg) {
    const std::size_t count = leg.joints.size();
    if (count != kJointsOfALeg && count != 1) {
      problems_.push_back(leg.place.problem(
          "joints", "has " + std::to_string(count) + " joints: give HAA, HFE, KFE, or the one joint of a rig"));
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [name, kind] = leg.joints[i];
      const auto [first, is_new] = joints_.emplace(name, leg_name);
      if (!is_new) {
        problems_.push_back(
            leg.joints_place.problem(name, "is the name of a joint of leg " + first->second + " too: rename one"));
      }
      const JointTemplate* joint = resolve(file_.joints, "joints", kind, leg.joints_place, name);
      const Load* load = joint != nullptr ? config::find(file_.loads, joint->load) : nullptr;
      if (load != nullptr && load->leg_about_haa && (count == 1 || (count == kJointsOfALeg && i != 0))) {
        problems_.push_back(
            leg.joints_place.problem(name, "has the whole leg as its load: only the first of three joints can"));
      }
    }
  }

  void check_effects(const std::string& joint, const JointEffectsSection& effects) {
    if (joints_.contains(joint) || config::find(file_.joints, joint) != nullptr) {
      return;
    }
    std::vector<std::string> known;
    std::string all;
    const auto add = [&](const auto& named) {
      known.push_back(named.first);
      all += (all.empty() ? " " : ", ") + named.first;
    };
    std::ranges::for_each(joints_, add);
    std::ranges::for_each(file_.joints, add);
    const std::string meant = config::suggest(joint, known).name;
    problems_.push_back(
        effects.place.problem("", "is neither a joint of a leg nor a section of joints" +
                                      (meant.empty() ? ": known are" + all : ": did you mean " + meant + "?")));
  }

  const RobotFile& file_;
  config::Problems problems_;
  std::map<std::string, std::string> joints_;
};

}  // namespace

config::Problems check_references(const RobotFile& file) { return ReferenceCheck(file).run(); }

}  // namespace farrier::robot
