#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/choice.hpp"
#include "core/result.hpp"
#include "plant/actuator.hpp"
#include "plant/linkage.hpp"

namespace farrier::gait {

enum class Pattern {
  kTrot,   ///< legs swing when their phase offset says so
  kStand,  ///< all legs on the ground, no motion
};
inline constexpr std::array kPatterns{Option<Pattern>{"trot", Pattern::kTrot},
                                      Option<Pattern>{"stand", Pattern::kStand}};

enum class ReferenceKind {
  kLegKinematics,  ///< feet follow the pattern, joints by inverse kinematics
  kMultisine,      ///< joints hold home, the force reference is a sum of sines (one-joint rig)
};

/// The robot's motion. Defaults: trot of HyQ as IIT runs it (1.4 Hz, duty 0.65, step 0.3 of the hip height).
struct GaitParams {
  Pattern pattern = Pattern::kTrot;
  double frequency_Hz = 1.4;       ///< strides per second, > 0; rounded to a whole number of ticks per stride
  double duty = 0.65;              ///< stance part of the stride, 0..1 exclusive
  double step_length_m = 0.172;    ///< way of the foot relative to the hip during stance, >= 0
  double step_height_m = 0.08;     ///< lift of the foot in mid-swing, >= 0
  double hip_height_m = 0.574;     ///< HAA axis above the centre of the foot sphere while standing, > 0
  /// Part of the stance in which the load comes in, and again in which it goes out, 0..0.5. At (duty - 0.5)/duty the
  /// two diagonals of a trot hand over exactly the weight of the robot.
  double load_transfer_fraction = 0.15 / 0.65;
  double touchdown_jitter_s = 0.0;  ///< actual touchdowns lie within +- this of the planned ones, >= 0
  double lead_in_s = 0.5;           ///< standing before the first stride, the load coming in, >= 0
  int announce_ticks = 40;          ///< a switch is announced this many ticks ahead; more than the jitter
  ReferenceKind reference = ReferenceKind::kLegKinematics;
  std::vector<double> multisine_frequencies_Hz;  ///< equal amplitudes, zero phase
  double multisine_amplitude_N = 0.0;            ///< sum of the amplitudes, actuator force (Nm for a rotary motor)
};

/// A leg of HyQ: HAA about the x axis, HFE and KFE about the leg's own lateral axis.
struct LegGeometry {
  double upper_m = 0.35;       ///< HFE to KFE, > 0
  double lower_m = 0.341;      ///< KFE to the centre of the foot sphere, > 0
  double hip_offset_m = 0.08;  ///< HAA axis to HFE, >= 0
  bool left = true;            ///< negative HAA moves the foot outward on either side
  bool front = true;           ///< front knees point backward (KFE < 0), hind knees forward (KFE > 0)
};

/// Data of one joint that the gait needs.
struct JointPlan {
  std::uint16_t joint;       ///< number of the joint on the bus
  plant::Linkage linkage;    ///< joint angle to actuator position
  plant::LoadParams swing_load, stance_load;  ///< actuator coordinates
  double home_angle_rad;
  double stiffness_Nm_rad, damping_Nms_rad;  ///< joint impedance sent with the reference (k_p, k_d)
};

/// One leg: three joints in the order HAA, HFE, KFE, or the one joint of a rig.
struct LegPlan {
  std::string name;
  LegGeometry geometry;
  std::vector<JointPlan> joints;
  double phase_offset;  ///< of the stride, 0 <= offset < 1; trot: lf 0, rf 0.5, lh 0.5, rh 0
};

struct RobotPlan {
  double period_s;       ///< duration of a tick, > 0
  double body_weight_N;  ///< weight of the whole robot, >= 0
  GaitParams gait;
  std::vector<LegPlan> legs;
};

/// Refuses a plan that Schedule or Reference could not carry out, naming the obstacle with its remedy: ranges, phases
/// shorter than an announcement, jitter not below the announcement, feet out of reach.
Result<Done> validate(const RobotPlan& plan);

}  // namespace farrier::gait
