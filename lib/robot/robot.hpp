#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "body/model/body_model.hpp"
#include "config/problem.hpp"
#include "control/design/design.hpp"
#include "control/law/feedback_linearisation.hpp"
#include "control/law/low_pass.hpp"
#include "control/design/lqr.hpp"
#include "control/law/flow_inversion.hpp"
#include "control/law/pid.hpp"
#include "core/result.hpp"
#include "core/time.hpp"
#include "gait/gait_params.hpp"
#include "locomotion/trot_controller.hpp"
#include "locomotion/supply_guard.hpp"
#include "plant/actuator.hpp"
#include "plant/electric_actuator.hpp"
#include "plant/linkage.hpp"
#include "plant/supply.hpp"
#include "plant/terms/active_effect.hpp"
#include "robot/robot_file.hpp"

namespace farrier::robot {

/// Standard deviations of the sensors, actuator coordinates (m, m/s, N or rad, rad/s, Nm).
struct SensorNoise {
  double position = 0.0;
  double velocity = 0.0;
  double force = 0.0;
};

/// Conversion and filters of a joint's sensors, actuator coordinates; default: a sample is the truth with its noise.
struct Sensors {
  control::LowPassParams position, velocity, force;  ///< digital, at the tick
  control::LowPassParams anti_alias;                 ///< analog, before each conversion of every channel
  int oversampling = 1;                              ///< conversions per tick, averaged; >= 1
  double position_step = 0.0;                        ///< m or rad; 0: none
};

/// One joint, everything derived and in SI. "Actuator coordinates" are m and N for a cylinder, rad and Nm for a motor.
struct Joint {
  std::string name;
  std::uint16_t number;  ///< its place in Robot::joints and its key on the bus
  int leg;               ///< its place in Robot::plan.legs
  int index_in_leg;
  bool rotary;  ///< a motor: rad and Nm
  /// An electric joint uses only `stroke` and `valve_current_max_A`, the largest current of its drive.
  plant::ActuatorParams actuator;
  std::optional<plant::ElectricParams> electric;  ///< of an electric joint
  plant::Linkage linkage;
  plant::LoadParams swing_load, stance_load;            ///< actuator coordinates
  double angle_min_rad, angle_max_rad, home_angle_rad;  ///< of this leg, mirrored where the leg is
  double push_limit, pull_limit;                        ///< largest force (N, Nm; positive) extending and retracting
  SensorNoise noise;                                    ///< of one conversion
  Sensors sensors;
  bool equalises_filters;  ///< the joint's node filters the faster channels until all lag alike (robot::equalisers)
  control::Kind kind;
  control::FeedbackLinearisationGains feedback_linearisation;  ///< act if the kind says so
  control::PidGains pid;                                       ///< likewise
  control::FlowInversionGains flow_inversion;                  ///< likewise
  control::Form form;
  control::DesignRule design;
  control::Normalisation normalisation;
  EstimatorParams estimator;
  double stiffness_Nm_rad, damping_Nms_rad;
  double dither_percent;  ///< probing current, plus or minus, of the valve's nominal current; 0: none
  int dither_hold_ticks;  ///< ticks for which it keeps its sign, >= 1
  std::vector<plant::ActiveEffect> effects;  ///< beside the model; those that change the load are in the loads above
};

struct Robot {
  std::string name;
  std::string path;  ///< of the file it came from
  double period_s;
  int loop_delay_lockstep, loop_delay_realtime;  ///< ticks
  int estimate_period_ticks;  ///< >= 1; one for all joints, so that in lock-step the tick determines the due estimates
  std::vector<Joint> joints;  ///< in the order of the file: leg by leg
  gait::RobotPlan plan;
  std::optional<body::BodyModel> body;                        ///< as rigid bodies; none if the file describes no trunk
  std::optional<plant::SupplyParams> supply;                  ///< shared by the joints of a body; none without a pump
  std::optional<locomotion::SupplyGuardParams> supply_guard;  ///< limits of that supply
  std::optional<locomotion::LocomotionParams> locomotion;     ///< of a robot that can walk on a ground
  bool on_ground = false;                                     ///< as Overrides has it; false without a body
  UpdateLogicParams update_logic;
  Safety safety;
  Bounds bounds;
  Variation variation;
  RobotFile file;  ///< source of all of the above, with defaults and overrides

  /// The joint of that name, null for none.
  const Joint* find(std::string_view joint_name) const noexcept;

  /// The first electric joint, null for none.
  const Joint* first_electric() const noexcept;

  /// True if every joint's estimate is published at this tick; in lock-step the supervisor waits for it.
  bool estimate_due(Tick tick) const noexcept { return tick % estimate_period_ticks == 0; }

  /// True if its file describes a trunk and its locomotion, so that it can walk on a ground.
  bool can_walk() const noexcept { return body.has_value() && locomotion.has_value(); }

  /// The error, with its remedy, where a robot that cannot walk is asked to.
  std::string cannot_walk_error() const;

  /// Ticks between two samples of supply/state, which are 10 ms apart, from tick 0 on; >= 1.
  Tick supply_ticks() const noexcept { return std::max<Tick>(1, std::llround(0.01 / period_s)); }
  /// Tick of the sample of supply/state that is due at this tick.
  Tick due_supply(Tick tick) const noexcept { return tick - tick % supply_ticks(); }
};

/// Settings that a command line may change.
struct Overrides {
  std::optional<gait::Pattern> pattern = std::nullopt;
  std::optional<double> frequency_Hz = std::nullopt;
  bool without_dither = false;                             ///< dither_percent of every joint is 0
  bool without_effects = false;                            ///< no joint has effects
  std::optional<std::string> estimator = std::nullopt;     ///< section of the file that every joint uses
  std::optional<control::Kind> controller = std::nullopt;  ///< kind of every controller
  bool on_ground = false;                                  ///< see put_on_ground() in robot.cpp
};

/// Loads and checks a robot file. Refuses with every mistake in it, each with its line and remedy; checks that need
/// several sections (references, strokes, reach of the gait) are made once each section by itself is good.
Result<Robot, config::Problems> load_robot(const std::string& path, const Overrides& overrides = {});

/// Same, from text; `file` names it in problems.
Result<Robot, config::Problems> load_robot_text(const std::string& text, const std::string& file,
                                                const Overrides& overrides = {});

/// Effective configuration as YAML: every parameter with its value. Loads again to the same robot.
std::string print_config(const Robot& robot);

/// Hash of print_config: equal for robots that behave the same; comments and order of keys in their files do not
/// matter.
std::uint64_t configuration_hash(const Robot& robot);

/// Markdown table of every parameter of a robot file.
std::string parameter_table();

}  // namespace farrier::robot
