#include "robot/robot_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "gait/leg_kinematics.hpp"
#include "robot/body_model.hpp"
#include "robot/checks/adaptation_check.hpp"
#include "robot/checks/cross_check.hpp"
#include "robot/checks/deployment_check.hpp"
#include "robot/derive.hpp"
#include "robot/checks/electric_check.hpp"
#include "robot/joint_effects.hpp"
#include "robot/leg_inertia.hpp"
#include "robot/locomotion_params.hpp"
#include "robot/references.hpp"

namespace farrier::robot {
namespace {

// One joint template on a leg of either direction of counting angles.
struct Instance {
  plant::Linkage linkage;
  double angle_min_rad, angle_max_rad, home_angle_rad;
};

class Builder {
 public:
  explicit Builder(RobotFile file) : file_(std::move(file)) { add_default_estimator(file_); }

  Result<Robot, config::Problems> build() {
    problems_ = check_references(file_);
    if (problems_.empty()) {
      check_geometry();
      for (const config::Problems& misfits :
           {check_adaptation(file_), check_between_sections(file_), check_deployment(file_)}) {
        problems_.insert(problems_.end(), misfits.begin(), misfits.end());
      }
    }
    if (!problems_.empty()) {
      return refuse();
    }
    Robot robot{.name = file_.name,
                .path = file_.place.file,
                .period_s = file_.period_s,
                .loop_delay_lockstep = file_.loop_delay_ticks.lockstep,
                .loop_delay_realtime = file_.loop_delay_ticks.realtime,
                .estimate_period_ticks = file_.estimate_period_ticks,
                .joints = {},
                .plan = {file_.period_s, body_weight_N(), file_.gait, {}},
                .body = make_body_model(file_),
                .supply = supply_params(file_),
                .supply_guard = supply_guard_params(file_),
                .locomotion = make_locomotion_params(file_),
                .update_logic = file_.update_logic.params,
                .safety = file_.safety.params,
                .bounds = file_.bounds,
                .variation = file_.variation.params,
                .file = {}};
    for (const auto& [name, leg] : file_.legs) {
      add_leg(name, leg, robot);
    }
    set_hip_height(robot.plan);
    check_values(robot);
    if (!problems_.empty()) {
      return refuse();
    }
    robot.file = std::move(file_);
    return robot;
  }

 private:
  Result<Robot, config::Problems> refuse() {
    config::sort_by_line(problems_);
    return std::move(problems_);
  }

  const Actuator& actuator_of(const JointTemplate& joint) const {
    return *config::find(file_.actuators, joint.actuator);
  }

  // Linkages must be triangles, and joint limits must stay within reach and stroke.
  void check_geometry() {
    for (const auto& [name, section] : file_.linkages) {
      if (const auto linkage = make_linkage(section, false); !linkage) {
        problems_.push_back(section.place.problem("", linkage.error().message));
      }
    }
    for (const auto& [name, joint] : file_.joints) {
      if (problems_.empty()) {
        check_limit(joint, "angle_min_rad", joint.angle_min_rad);
        check_limit(joint, "angle_max_rad", joint.angle_max_rad);
      }
    }
  }

  void check_limit(const JointTemplate& joint, const char* key, double angle_rad) {
    constexpr double kLimitRounding = 1e-9;  // of the stroke: a limit may lie exactly on an end
    const LinkageSection& section = *config::find(file_.linkages, joint.linkage);
    const double stroke = stroke_of(file_, joint);
    if (section.triangle) {
      const double enclosed =
          section.triangle->angle_at_zero_rad + (section.triangle->opens_with_angle ? angle_rad : -angle_rad);
      if (!(enclosed > 0.0 && enclosed < std::numbers::pi)) {
        problems_.push_back(joint.place.problem(key, "folds linkage " + joint.linkage + " beyond its dead centre"));
        return;
      }
    }
    const double position = make_linkage(section, false).value().position(angle_rad);
    if (position < -kLimitRounding * stroke || position > (1.0 + kLimitRounding) * stroke) {
      problems_.push_back(joint.place.problem(key, config::number_text(angle_rad) + " puts actuator " + joint.actuator +
                                                       " at " + config::number_text(position) +
                                                       ", outside its stroke: 0 to " + config::number_text(stroke)));
    }
  }

  Instance instance(const JointTemplate& joint, const Leg& leg) const {
    const bool mirrored = joint.mirrored_in_front && leg.front;
    plant::Linkage linkage = make_linkage(*config::find(file_.linkages, joint.linkage), mirrored).value();
    return mirrored ? Instance{linkage, -joint.angle_max_rad, -joint.angle_min_rad, -joint.home_angle_rad}
                    : Instance{linkage, joint.angle_min_rad, joint.angle_max_rad, joint.home_angle_rad};
  }

  double body_weight_N() const { return file_.body ? robot_weight_N(*file_.body, file_.legs.size()) : 0.0; }

  // Mean of the levers at home; mirrored legs have the same.
  double motor_lever_m(const RotaryMotor& motor) const {
    double sum = 0.0;
    for (const std::string& name : motor.lever_joints) {
      const JointTemplate& joint = *config::find(file_.joints, name);
      const LinkageSection& section = *config::find(file_.linkages, joint.linkage);
      sum += std::abs(make_linkage(section, false).value().lever(joint.home_angle_rad));
    }
    return sum / static_cast<double>(motor.lever_joints.size());
  }

  // Inertia of the leg with its joints at home; the plane's mirror images are alike, so a front leg's angles suffice.
  double leg_inertia_kg_m2(const Leg& leg) const {
    const double hfe = home_of(leg, 1);
    const double kfe = home_of(leg, 2);
    return leg_inertia_about_haa_kg_m2(*file_.body, leg.front ? hfe : -hfe, leg.front ? kfe : -kfe);
  }

  double home_of(const Leg& leg, std::size_t index) const {
    return instance(*config::find(file_.joints, leg.joints[index].second), leg).home_angle_rad;
  }

  void add_leg(const std::string& name, const Leg& leg, Robot& robot) {
    gait::LegPlan plan{.name = name, .geometry = {}, .joints = {}, .phase_offset = leg.phase_offset};
    plan.geometry.left = leg.left;
    plan.geometry.front = leg.front;
    if (file_.body) {
      plan.geometry.upper_m = file_.body->upper_leg_m;
      plan.geometry.lower_m = file_.body->lower_leg_m;
      plan.geometry.hip_offset_m = file_.body->hip_offset_m;
    }
    for (const auto& [joint_name, template_name] : leg.joints) {
      Joint joint = make_joint(joint_name, *config::find(file_.joints, template_name), leg);
      for (const config::Problem& misfit : add_effects(file_.effects, template_name, joint)) {
        if (std::ranges::find(problems_, misfit) == problems_.end()) {  // of a kind of joint: once for all legs
          problems_.push_back(misfit);
        }
      }
      joint.number = static_cast<std::uint16_t>(robot.joints.size());
      joint.leg = static_cast<int>(robot.plan.legs.size());
      joint.index_in_leg = static_cast<int>(plan.joints.size());
      plan.joints.push_back({joint.number, joint.linkage, joint.swing_load, joint.stance_load, joint.home_angle_rad,
                             joint.stiffness_Nm_rad, joint.damping_Nms_rad});
      robot.joints.push_back(std::move(joint));
    }
    robot.plan.legs.push_back(std::move(plan));
  }

  Joint make_joint(const std::string& name, const JointTemplate& from, const Leg& leg) const {
    const Load& load = *config::find(file_.loads, from.load);
    const Controller& controller = *config::find(file_.controllers, from.controller);
    const Instance here = instance(from, leg);
    Joint joint{.name = name,
                .number = 0,
                .leg = 0,
                .index_in_leg = 0,
                .rotary = false,
                .actuator = {},
                .electric = {},
                .linkage = here.linkage,
                .swing_load = {},
                .stance_load = {},
                .angle_min_rad = here.angle_min_rad,
                .angle_max_rad = here.angle_max_rad,
                .home_angle_rad = here.home_angle_rad,
                .push_limit = 0.0,
                .pull_limit = 0.0,
                .noise = {},
                .sensors = {},
                .equalises_filters = controller.equalise_filters,
                .kind = controller.kind,
                .feedback_linearisation = controller.feedback_linearisation,
                .pid = controller.pid,
                .flow_inversion = controller.flow_inversion,
                .form = controller.form,
                .design = controller.design,
                .normalisation = {},
                .estimator = config::find(file_.estimators, from.estimator)->params,
                .stiffness_Nm_rad = from.stiffness_Nm_rad,
                .damping_Nms_rad = from.damping_Nms_rad,
                .dither_percent = from.dither_percent,
                .dither_hold_ticks = from.dither_hold_ticks,
                .effects = {}};
    if (const ElectricActuator* electric = electric_actuator_of(file_, from)) {
      drive_electrically(joint, *electric, *load.rotary);
    } else {
      drive_hydraulically(joint, actuator_of(from), load, leg);
    }
    return joint;
  }

  void drive_hydraulically(Joint& joint, const Actuator& actuator, const Load& load, const Leg& leg) const {
    const Valve& valve = *config::find(file_.valves, actuator.valve);
    double rated = 0.0;
    joint.rotary = actuator.rotary_motor.has_value();
    if (actuator.cylinder) {
      joint.actuator = cylinder_params(*file_.supply, valve, actuator);
      joint.swing_load = cylinder_load(*load.swing);
      joint.stance_load = cylinder_load(*load.stance);
      joint.noise = cylinder_noise(actuator.cylinder->noise);
      joint.sensors = sensors(actuator.cylinder->sensors, 1.0);
      joint.normalisation = cylinder_normalisation(*actuator.cylinder, joint.actuator);
      rated = actuator.cylinder->rated_force_N;
    } else {
      const RotaryMotor& motor = *actuator.rotary_motor;
      const Cylinder& like = *config::find(file_.actuators, motor.like_cylinder)->cylinder;
      const CylinderLoad& damping = *config::find(file_.loads, load.leg_about_haa->damping_like)->swing;
      const double lever_m = motor_lever_m(motor);
      joint.actuator = motor_params(*file_.supply, valve, actuator, like, lever_m);
      joint.swing_load = leg_load(leg_inertia_kg_m2(leg), damping, lever_m);
      joint.stance_load = joint.swing_load;
      joint.noise = motor_noise(like.noise, lever_m);
      joint.sensors = sensors(like.sensors, lever_m);
      joint.normalisation = motor_normalisation(like, joint.actuator, lever_m);
      rated = motor.rated_torque_Nm;
    }
    const ForceLimits limits = force_limits(joint.actuator, rated);
    joint.push_limit = limits.push;
    joint.pull_limit = limits.pull;
  }

  // Sets the height of the hip to that of the legs at home.
  static void set_hip_height(gait::RobotPlan& plan) {
    for (const gait::LegPlan& leg : plan.legs) {
      if (leg.joints.size() == kJointsOfALeg) {
        plan.gait.hip_height_m = -gait::fk(leg.geometry, {leg.joints[0].home_angle_rad, leg.joints[1].home_angle_rad,
                                                          leg.joints[2].home_angle_rad})
                                      .z();
        return;
      }
    }
  }

  // The layers below have the last word on the values they get.
  void check_values(const Robot& robot) {
    std::set<std::string> told;
    for (const Joint& joint : robot.joints) {
      const Leg& leg = file_.legs[static_cast<std::size_t>(joint.leg)].second;
      const std::string& kind = leg.joints[static_cast<std::size_t>(joint.index_in_leg)].second;
      if (!told.insert(kind).second) {
        continue;
      }
      const JointTemplate& from = *config::find(file_.joints, kind);
      if (const ElectricActuator* electric = electric_actuator_of(file_, from)) {
        require(plant::validate(*joint.electric), electric->place);
      } else {
        require(plant::validate(joint.actuator), actuator_of(from).place);
      }
      require(plant::validate(joint.swing_load), config::find(file_.loads, from.load)->place);
      require(plant::validate(joint.stance_load), config::find(file_.loads, from.load)->place);
    }
    if (const auto good = gait::validate(robot.plan); !good) {
      problems_.push_back(file_.place.problem("gait", good.error().message));
    }
  }

  void require(const Result<Done>& good, const config::Place& place) {
    if (!good) {
      problems_.push_back(place.problem("", good.error().message));
    }
  }

  RobotFile file_;
  config::Problems problems_;
};

}  // namespace

Result<Robot, config::Problems> build_robot(RobotFile file) { return Builder(std::move(file)).build(); }

}  // namespace farrier::robot
