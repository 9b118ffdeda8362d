#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/visitor.hpp"
#include "gait/gait_params.hpp"
#include "robot/sections/actuator_section.hpp"
#include "robot/sections/adaptation_section.hpp"
#include "robot/sections/body_section.hpp"
#include "robot/sections/deployment_section.hpp"
#include "robot/sections/joint_effects_section.hpp"
#include "robot/sections/locomotion_section.hpp"
#include "robot/sections/variation_section.hpp"

namespace farrier::robot {

/// HAA, HFE, KFE: the joints of a leg in leg kinematics. A rig has one joint.
inline constexpr std::size_t kJointsOfALeg = 3;

/// Reactions of a joint to missing inputs, the table of docs/architecture.md, and the lead for early touchdowns.
struct Safety {
  double sensors_stale_s = 0.003;      ///< sensors older than this: valve to null
  double command_damping_s = 0.005;    ///< command older than this: damping only
  double command_trip_s = 0.050;       ///< command older than this: valve to null, latched
  double valve_silent_s = 0.005;       ///< no valve command for this long: spool to null
  int recovery_samples = 10;           ///< good sensor samples that end a stale spell
  int frozen_samples = 0;              ///< samples alike in every number that make sensors stale; 0: never
  double damping_gain_Nms_rad = 20.0;  ///< of the joint while its command is late: tau = -gain qdot
  double position_damping_1_s = 5.0;   ///< speed per distance of the return to where a joint lost its force
  double stance_lead_s = 0.0;          ///< stance gains act this long before the announced touchdown
};

struct SafetySection {
  Safety params;
  config::Place place;
};

/// Bounds by which a run is judged.
struct Bounds {
  double stance_nrmse = 0.10;  ///< largest tolerated NRMSE in stance
  bool judged = true;          ///< true if a run on this robot fails when it is exceeded
};

/// Ticks between a sensor sample and the first valve command that depends on it; every design assumes it.
struct LoopDelay {
  int lockstep = 0;
  int realtime = 1;
};

/// A joint as all legs have it. On front legs of a mirrored joint angles count the other way.
struct JointTemplate {
  std::string actuator;
  std::string linkage;
  std::string load;
  std::string controller;
  std::string estimator = kDefaultEstimator;
  bool mirrored_in_front = false;
  double angle_min_rad = 0.0;
  double angle_max_rad = 0.0;
  double home_angle_rad = 0.0;
  double stiffness_Nm_rad = 0.0;
  double damping_Nms_rad = 0.0;
  double dither_percent = 0.0;  ///< of the valve's nominal current: the probing current is plus or minus this
  int dither_hold_ticks = 1;    ///< for which it keeps its sign
  config::Place place;
};

struct Leg {
  bool front = true;
  bool left = true;
  double phase_offset = 0.0;
  std::vector<double> hip_position_m;  ///< of the HAA axis in the trunk's frame: x, y, z; empty without body.trunk
  config::Named<std::string> joints;   ///< joint name to joint template, HAA, HFE, KFE
  config::Place joints_place;
  config::Place place;
};

/// A robot file, deploy/robots/*.yaml, as it is written: sections that refer to each other by name.
struct RobotFile {
  std::string name;
  double period_s = 0.001;
  LoopDelay loop_delay_ticks;
  int estimate_period_ticks = 10;
  std::optional<Supply> supply;
  std::optional<Body> body;
  config::Named<Valve> valves;
  config::Named<Actuator> actuators;                   ///< hydraulic
  config::Named<ElectricActuator> electric_actuators;  ///< none has the name of another actuator
  config::Named<LinkageSection> linkages;
  config::Named<Load> loads;
  config::Named<Controller> controllers;
  config::Named<EstimatorSection> estimators;
  UpdateLogicSection update_logic;
  config::Named<JointTemplate> joints;
  config::Named<Leg> legs;
  gait::GaitParams gait;
  std::optional<LocomotionSection> locomotion;  ///< of a robot that can walk on a ground
  SafetySection safety;
  Bounds bounds;
  VariationSection variation;
  config::Named<JointEffectsSection> effects_on_ground;  ///< in addition to those, on a ground
  config::Named<JointEffectsSection> effects;            ///< by joint or section of joints, none named twice
  std::optional<Deployment> deployment;                  ///< over several computers
  config::Place place;
};

void declare(config::Visitor& v, SafetySection& safety);
void declare(config::Visitor& v, Bounds& bounds);
void declare(config::Visitor& v, LoopDelay& delay);
void declare(config::Visitor& v, JointTemplate& joint);
void declare(config::Visitor& v, Leg& leg);
void declare(config::Visitor& v, RobotFile& file);

/// Declares gait::GaitParams; a wrapper because declarations are found beside their struct, and gait knows no config.
struct GaitSection {
  gait::GaitParams* params = nullptr;
};
void declare(config::Visitor& v, GaitSection& gait);

}  // namespace farrier::robot
