#include "robot/robot_file.hpp"

#include <array>

namespace farrier::robot {

using config::Default;
using config::Defaults;
using config::kInitial;
using config::Option;
using config::Visitor;

void declare(Visitor& v, SafetySection& section) {
  Safety& s = section.params;
  v.here(section.place);
  v.number("sensors_stale_s", s.sensors_stale_s, {1e-4, 1}, kInitial, "Sensors older than this: valve to null.");
  v.number("command_damping_s", s.command_damping_s, {1e-4, 1}, kInitial, "Command older than this: damping.");
  v.number("command_trip_s", s.command_trip_s, {1e-3, 10}, kInitial,
           "Command older than this: valve to null until re-armed.");
  v.number("valve_silent_s", s.valve_silent_s, {1e-4, 1}, kInitial, "No valve command for this long: spool to null.");
  v.integer("recovery_samples", s.recovery_samples, {1, 10000}, kInitial,
            "Good sensor samples that end a stale spell.");
  v.number("damping_gain_Nms_rad", s.damping_gain_Nms_rad, {0, 1e4}, kInitial,
           "Joint torque against the joint's velocity while its command is late (Ns/m on a rig).");
  v.number("position_damping_1_s", s.position_damping_1_s, {0, 20}, kInitial,
           "Speed towards the position where the force was lost, over the distance from it; 0: the valve stays shut.");
  v.integer("frozen_samples", s.frozen_samples, {0, 10000}, kInitial,
            "Samples that are alike in every number, as noise never is, after which sensors count as stale; 0: never.");
  v.number("stance_lead_s", s.stance_lead_s, {0, 0.1}, kInitial,
           "Stance gains act this long before the announced touchdown, for one that comes early.");
  v.check(s.command_damping_s < s.command_trip_s, "command_trip_s", "must be longer than command_damping_s");
}

void declare(Visitor& v, Bounds& b) {
  v.number("stance_nrmse", b.stance_nrmse, {1e-3, 10}, kInitial,
           "Largest tolerated NRMSE of the force in stance: RMS error over the RMS of the reference about its mean.");
  v.flag("judged", b.judged, kInitial, "Whether a run fails when the bound is exceeded.");
}

void declare(Visitor& v, LoopDelay& d) {
  v.integer("lockstep", d.lockstep, {0, 2}, kInitial, "On a simulated clock.");
  v.integer("realtime", d.realtime, {0, 2}, kInitial, "On the machine's clock.");
}

void declare(Visitor& v, JointTemplate& j) {
  v.here(j.place);
  v.name("actuator", j.actuator, kLongestName, "Its actuator, by name.");
  v.name("linkage", j.linkage, kLongestName, "Its linkage, by name.");
  v.name("load", j.load, kLongestName, "Its load, by name.");
  v.name("controller", j.controller, kLongestName, "Its controller, by name.");
  v.name("estimator", j.estimator, kLongestName, Default{kDefaultEstimator},
         "Its estimator, by name; default is always there.");
  v.flag("mirrored_in_front", j.mirrored_in_front, kInitial,
         "Whether front legs count its angle the other way; the angles below are a hind leg's.");
  v.number("angle_min_rad", j.angle_min_rad, {-10, 10}, "Lower joint limit.");
  v.number("angle_max_rad", j.angle_max_rad, {-10, 10}, "Upper joint limit.");
  v.number("home_angle_rad", j.home_angle_rad, {-10, 10}, "Home pose.");
  v.number("stiffness_Nm_rad", j.stiffness_Nm_rad, {0, 1e5}, "Joint impedance, k_p.");
  v.number("damping_Nms_rad", j.damping_Nms_rad, {0, 1e4}, "Joint impedance, k_d.");
  v.number("dither_percent", j.dither_percent, {0, 10}, kInitial,
           "Probing current, plus or minus this much of the valve's current_max_A; 0 is none.");
  v.integer("dither_hold_ticks", j.dither_hold_ticks, {1, 100}, kInitial,
            "Ticks for which the probing current keeps its sign.");
  v.check(j.angle_min_rad < j.angle_max_rad, "angle_max_rad", "must be above angle_min_rad");
  v.check(j.home_angle_rad >= j.angle_min_rad && j.home_angle_rad <= j.angle_max_rad, "home_angle_rad",
          "must lie between angle_min_rad and angle_max_rad");
}

void declare(Visitor& v, Leg& l) {
  v.here(l.place);
  v.flag("front", l.front, "Front or hind: the knee bends backward or forward.");
  v.flag("left", l.left, "Left or right.");
  v.number("phase_offset", l.phase_offset, {0, 0.999999}, "Share of the stride by which this leg is late.");
  v.numbers("hip_position_m", l.hip_position_m, {-10, 10},
            "Where the HAA axis meets the leg's plane: forward, to the left and above the trunk's origin.");
  v.check(l.hip_position_m.empty() || l.hip_position_m.size() == 3, "hip_position_m",
          "is no position: give three numbers, x, y and z");
  v.pairs("joints", l.joints, l.joints_place, kLongestName,
          "Joint names and what each is an instance of, in the order HAA, HFE, KFE.");
}

void declare(Visitor& v, GaitSection& section) {
  gait::GaitParams& g = *section.params;
  constexpr std::array kReferences = {
      Option<gait::ReferenceKind>{"leg_kinematics", gait::ReferenceKind::kLegKinematics},
      Option<gait::ReferenceKind>{"multisine", gait::ReferenceKind::kMultisine}};
  v.choice<gait::Pattern>("pattern", g.pattern, gait::kPatterns, kInitial,
                          "`trot`: legs step as `phase_offset` and `duty` say. `stand`: all legs stand.");
  v.number("frequency_Hz", g.frequency_Hz, {0.05, 10}, "Strides per second.");
  v.number("duty", g.duty, {0.05, 0.95}, "Stance part of the stride.");
  // A robot whose file gives neither steps in place.
  v.number("step_length_m", g.step_length_m, {0, 2}, Default{0.0}, "Way of the foot under the hip during stance.");
  v.number("step_height_m", g.step_height_m, {0, 1}, Default{0.0}, "Lift of the foot in mid-swing.");
  v.number("load_transfer_fraction", g.load_transfer_fraction, {0, 0.5}, kInitial,
           "Part of the stance in which the load comes in, and again in which it goes out.");
  v.number("touchdown_jitter_s", g.touchdown_jitter_s, {0, 0.2}, kInitial,
           "Actual touchdowns lie within plus or minus this of the planned ones.");
  v.number("lead_in_s", g.lead_in_s, {0, 60}, kInitial, "Standing before the first stride.");
  v.integer("announce_ticks", g.announce_ticks, {1, 10000}, kInitial, "A switch is announced this many ticks ahead.");
  v.choice<gait::ReferenceKind>("reference", g.reference, kReferences, kInitial,
                                "Joint references from leg kinematics, or a sum of sines as force (a rig).");
  v.numbers("multisine_frequencies_Hz", g.multisine_frequencies_Hz, {1e-3, 400}, "Equal amplitudes, zero phase.");
  v.number("multisine_amplitude_N", g.multisine_amplitude_N, {0, 1e5}, kInitial, "Sum of the amplitudes.");
  v.check(g.reference != gait::ReferenceKind::kMultisine || !g.multisine_frequencies_Hz.empty(),
          "multisine_frequencies_Hz", "a multisine needs at least one frequency");
}

void declare(Visitor& v, RobotFile& f) {
  v.here(f.place);
  v.name("name", f.name, kLongestName, "Name of the robot, its partition on the bus.");
  v.number("period_s", f.period_s, {1e-4, 0.1}, kInitial, "Period of the joint loop; a tick.");
  v.group("loop_delay_ticks", f.loop_delay_ticks,
          "Ticks from a sensor sample to the first valve command that knows it; designs are made for it.");
  v.integer("estimate_period_ticks", f.estimate_period_ticks, {1, 1000}, kInitial,
            "Ticks between two estimates of a joint.");
  v.group("supply", f.supply, "Oil and its pressure; absent where no actuator is hydraulic.");
  v.group("body", f.body, "Rigid body; absent for a rig, which then weighs nothing.");
  v.groups("valves", f.valves, kLongestName, Defaults{}, "Servo valves, of hydraulic actuators.");
  v.groups("actuators", f.actuators, kLongestName, Defaults{}, "Hydraulic actuators: cylinders and motors.");
  v.groups("electric_actuators", f.electric_actuators, kLongestName, Defaults{}, "Electric actuators.");
  v.check(!f.actuators.empty() || !f.electric_actuators.empty(), "",
          "has no actuator: give actuators, electric_actuators or both");
  v.groups("linkages", f.linkages, kLongestName, "Geometry between joint angle and actuator position.");
  v.groups("loads", f.loads, kLongestName, "What an actuator moves.");
  v.groups("controllers", f.controllers, kLongestName, "Weights of the force loop.");
  v.groups("estimators", f.estimators, kLongestName, Defaults{}, "How the dynamics of a joint are estimated.");
  v.group("update_logic", f.update_logic, Defaults{}, "When an estimate leads to new gains.");
  v.groups("joints", f.joints, kLongestName, "Joints, once for all legs.");
  v.groups("legs", f.legs, kLongestName, "Legs, in the order in which joints are numbered.");
  GaitSection gait{&f.gait};
  v.group("gait", gait, "How the robot moves.");
  v.group("locomotion", f.locomotion, "Control of the whole robot on a ground; needs body.trunk.");
  v.group("safety", f.safety, "What a joint does when something is missing.");
  v.group("bounds", f.bounds, "What a run is judged by.");
  v.group("variation", f.variation, Defaults{}, "How far robots of `farrier compare varied` are drawn from this one.");
  v.groups("effects", f.effects, kLongestName, Defaults{},
           "What a joint has beside its model, by joint, or section of joints, and effect.");
  v.groups("effects_on_ground", f.effects_on_ground, kLongestName, Defaults{},
           "The same, in addition, of a robot on a ground (--world body).");
  v.group("deployment", f.deployment, "Which computer runs what; for `farrier deploy`.");
}

}  // namespace farrier::robot
