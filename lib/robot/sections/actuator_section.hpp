#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "config/visitor.hpp"
#include "control/design/design.hpp"
#include "control/law/feedback_linearisation.hpp"
#include "control/law/flow_inversion.hpp"
#include "control/law/pid.hpp"
#include "robot/sections/effects_section.hpp"
#include "robot/sections/electric_section.hpp"

namespace farrier::robot {

// Sections of a robot file about actuators and their loads. The sentence, unit and range of every parameter are in the
// `declare` functions (actuator_section.cpp); docs and checks come from there.

inline constexpr std::size_t kLongestName = 15;  ///< of a joint, leg or section: they travel as bus keys and labels

/// Pump, relief valve and hoses of a robot on a ground.
struct Pump {
  double flow_m3_s = 0.0;
  double hose_compliance_m3_Pa = 1.4e-12;
  double null_leakage_m3_s_Pa = 0.0;
};

struct Accumulator {
  double volume_m3 = 0.0;
  double precharge_Pa = 0.0;
  double polytropic_exponent = 1.3;
};

struct Supply {
  double supply_pressure_Pa = 0.0;
  double return_pressure_Pa = 0.0;
  double bulk_modulus_Pa = 0.0;
  double laminar_pressure_Pa = 1e5;
  std::optional<Pump> pump;
  std::optional<Accumulator> accumulator;
  double low_share = 0.8;
  double slow_share = 0.85;
  double recovered_share = 0.9;
  double lie_share = 0.6;
  double stand_after_s = 0.3;
  double slowest = 0.3;
};

struct Valve {
  double gain_m3_s_AsqrtPa = 0.0;
  double current_max_A = 0.0;
};

/// End stops: a stiff contact.
struct Stops {
  double stiffness_N_m = 0.0;
  double damping_Ns_m = 0.0;
};

struct CylinderNoise {
  double position_m = 0.0;
  double velocity_m_s = 0.0;
  double force_N = 0.0;
};

struct Cylinder {
  double bore_m = 0.0;
  double rod_m = 0.0;
  double stroke_m = 0.0;
  double piston_mass_kg = 0.0;
  double piston_damping_Ns_m = 0.0;
  double rated_force_N = 0.0;
  double velocity_norm_m_s = 1.2;
  double force_norm_N = 5000.0;
  Stops stops;
  CylinderNoise noise;
  std::optional<SensorSection> sensors;
};

/// A vane motor. Values that no data sheet gives come from a cylinder whose force would act on a mean lever.
struct RotaryMotor {
  double displacement_m3_rad = 0.0;
  double travel_rad = 0.0;
  double rated_torque_Nm = 0.0;
  std::string like_cylinder;
  std::vector<std::string> lever_joints;
  config::Place place;
};

struct Actuator {
  std::string valve;
  double line_volume_m3 = 0.0;
  std::optional<LineSection> lines;
  std::optional<Cylinder> cylinder;
  std::optional<RotaryMotor> rotary_motor;
  config::Place place;
};

struct Triangle {
  double side_a_m = 0.0;
  double side_b_m = 0.0;
  double angle_at_zero_rad = 0.0;
  bool opens_with_angle = true;
  double retracted_length_m = 0.0;
};

struct Direct {
  double lever = 1.0;
  double zero_angle_rad = 0.0;
};

struct LinkageSection {
  std::optional<Triangle> triangle;
  std::optional<Direct> direct;
  config::Place place;
};

struct CylinderLoad {
  double mass_kg = 0.0;
  double damping_Ns_m = 0.0;
  double stiffness_N_m = 0.0;
  double equilibrium_position_m = 0.0;
};

/// The load of a rotary hip: the leg itself.
struct LegLoad {
  std::string damping_like;
  config::Place place;
};

struct Load {
  std::optional<CylinderLoad> swing;
  std::optional<CylinderLoad> stance;
  std::optional<LegLoad> leg_about_haa;
  std::optional<RotaryLoads> rotary;
  config::Place place;
};

/// A group of its own in the file.
struct PidSection : control::PidGains {};

/// A group of its own in the file.
struct FlowInversionSection : control::FlowInversionGains {};

/// As in a robot file.
inline constexpr std::array kControllerKinds = {
    config::Option<control::Kind>{"lqr", control::Kind::kLqr},
    config::Option<control::Kind>{"feedback_linearisation", control::Kind::kFeedbackLinearisation},
    config::Option<control::Kind>{"pid", control::Kind::kPid},
    config::Option<control::Kind>{"flow_inversion", control::Kind::kFlowInversion}};

struct Controller {
  control::Kind kind = control::Kind::kLqr;
  control::Form form = control::Form::kCompliant;
  control::DesignRule design;
  bool equalise_filters = false;  ///< the faster channels of a measurement are filtered until all lag alike
  control::FeedbackLinearisationGains feedback_linearisation;
  PidSection pid;
  FlowInversionSection flow_inversion;
};

void declare(config::Visitor& v, Supply& supply);
void declare(config::Visitor& v, Valve& valve);
void declare(config::Visitor& v, Stops& stops);
void declare(config::Visitor& v, CylinderNoise& noise);
void declare(config::Visitor& v, Cylinder& cylinder);
void declare(config::Visitor& v, RotaryMotor& motor);
void declare(config::Visitor& v, Actuator& actuator);
void declare(config::Visitor& v, Triangle& triangle);
void declare(config::Visitor& v, Direct& direct);
void declare(config::Visitor& v, LinkageSection& linkage);
void declare(config::Visitor& v, CylinderLoad& load);
void declare(config::Visitor& v, LegLoad& load);
void declare(config::Visitor& v, Load& load);
void declare(config::Visitor& v, PidSection& pid);
void declare(config::Visitor& v, FlowInversionSection& shares);
void declare(config::Visitor& v, Controller& controller);

}  // namespace farrier::robot
