#include "robot/sections/locomotion_section.hpp"

namespace farrier::locomotion {

using config::kInitial;
using config::Visitor;

namespace {

// One parameter for several elements of a vector that are alike.
template <class Elements>
void number_of_all(Visitor& v, const char* name, Elements elements, config::Range range, const char* sentence) {
  double value = elements[0];
  v.number(name, value, range, kInitial, sentence);
  elements.setConstant(value);
}

void declare_attitude(Visitor& v, AttitudeFilterParams& a) {
  v.number("gravity_gain_1_s", a.gravity_gain_1_s, {0, 100}, kInitial,
           "k_P of the attitude filter while the robot moves; its inverse is the time constant of roll and pitch.");
  v.number("gyroscope_bias_gain_1_s2", a.bias_gain_1_s2, {0, 100}, kInitial,
           "k_I of the attitude filter; at most k_P^2 / 4 is free of overshoot.");
  v.number("still_gravity_gain_1_s", a.still_gravity_gain_1_s, {0, 100}, kInitial, "k_P of a robot at rest.");
  v.number("yaw_bias_time_constant_s", a.moving_time_constant_s, {1e-2, 1e4}, kInitial,
           "Of the gyroscope's yaw bias, which standing feet show while the robot walks.");
  v.number("still_bias_time_constant_s", a.still_time_constant_s, {1e-2, 1e4}, kInitial,
           "Memory of the gyroscope's bias that a robot at rest averages.");
}

void declare_base(Visitor& v, BaseEstimatorParams& b) {
  v.number("acceleration_noise_m_s2_rtHz", b.acceleration_noise_m_s2_rtHz, {1e-6, 1e2}, kInitial,
           "Noise density of accelerometer and attitude.");
  v.number("foot_slip_m_s_rtHz", b.foot_slip_m_s_rtHz, {1e-6, 1e2}, kInitial,
           "Random walk of a foot that stands, density.");
  v.number("foot_position_noise_m", b.foot_position_noise_m, {1e-6, 1}, kInitial,
           "Standard deviation of leg kinematics.");
  v.number("foot_velocity_noise_m_s", b.foot_velocity_noise_m_s, {1e-6, 10}, kInitial,
           "Standard deviation of a foot's velocity by joints and gyroscope.");
  v.number("trust_ramp", b.trust_ramp, {0, 0.5}, kInitial, "Part of the stance at either end with less trust.");
  v.number("distrust", b.distrust, {1, 1e6}, kInitial, "Factor on a foot's standard deviations at no trust.");
  v.number("gate", b.gate, {0.1, 1e3}, kInitial, "Innovations beyond this many deviations are not believed.");
  v.number("initial_velocity_m_s", b.initial_velocity_m_s, {1e-6, 10}, kInitial,
           "Standard deviation of the velocity at the start.");
}

}  // namespace

void declare(Visitor& v, StateEstimatorParams& e) {
  declare_attitude(v, e.attitude);
  declare_base(v, e.base);
  v.number("trusted_force_N", e.trusted_force_N, {1e-3, 1e5}, kInitial,
           "A standing foot that carries less is trusted in proportion.");
  v.number("still_rate_rad_s", e.still_rate_rad_s, {1e-6, 10}, kInitial,
           "A robot that turns faster does not stand still.");
  v.number("acceleration_time_constant_s", e.acceleration_time_constant_s, {1e-3, 1e2}, kInitial,
           "Of the trunk's acceleration, by which the attitude is corrected.");
}

void declare(Visitor& v, LegSequencerParams& c) {
  v.number("early_force_N", c.early_force_N, {1e-3, 1e5}, kInitial, "A normal force above this ends a swing.");
  v.number("late_force_N", c.late_force_N, {1e-3, 1e5}, kInitial, "The same after the swing.");
  v.number("early_progress", c.early_progress, {0, 1}, kInitial, "Share of the swing from which on a contact ends it.");
  v.number("lost_speed_m_s", c.lost_speed_m_s, {1e-3, 1e2}, kInitial,
           "A standing foot that falls faster has lost the ground.");
  v.number("settle_s", c.settle_s, {0, 1}, kInitial, "After a touchdown the contact counts as kept for this long.");
}

void declare(Visitor& v, FeltTouchdownParams& f) {
  v.flag("on", f.on, kInitial, "False: gains of stance wait for the planned touchdown.");
  v.number("force_N", f.force_N, {1e-3, 1e5}, kInitial, "Normal force that counts as a touchdown.");
  v.number("debounce_s", f.debounce_s, {0, 0.1}, kInitial, "The force must stay above for this long.");
  v.number("least_swing_s", f.least_swing_s, {0, 10}, kInitial,
           "The gains of swing act at least so long before a touchdown that is felt.");
}

void declare(Visitor& v, GroundPlaneParams& g) {
  v.number("time_constant_s", g.time_constant_s, {1e-3, 1e2}, kInitial, "Low-pass of height and slope.");
  v.number("largest_slope", g.largest_slope, {1e-3, 2}, kInitial, "Rise per metre in either direction.");
}

void declare(Visitor& v, TrunkReferenceParams& r) {
  v.number("default_height_m", r.default_height_m, {0.01, 10}, "Trunk's origin above the ground.");
  v.number("least_height_m", r.least_height_m, {0.01, 10}, "Lower limit of a commanded height.");
  v.number("largest_height_m", r.largest_height_m, {0.01, 10}, "Upper limit of a commanded height.");
  v.number("height_speed_m_s", r.height_speed_m_s, {1e-3, 10}, kInitial, "Speed of a change of height.");
  v.number("fastest_forward_m_s", r.fastest_forward_m_s, {0, 10}, kInitial, "Commands are clamped to this.");
  v.number("fastest_left_m_s", r.fastest_left_m_s, {0, 10}, kInitial, "The same to either side.");
  v.number("fastest_yaw_rad_s", r.fastest_yaw_rad_s, {0, 10}, kInitial, "The same of turning.");
  v.number("acceleration_m_s2", r.acceleration_m_s2, {1e-3, 1e2}, kInitial, "Ramp of the velocities.");
  v.number("yaw_acceleration_rad_s2", r.yaw_acceleration_rad_s2, {1e-3, 1e2}, kInitial, "Ramp of the yaw rate.");
  v.number("position_slack_m", r.position_slack_m, {0, 10}, kInitial,
           "Largest position error that the trunk is pulled by.");
  v.number("yaw_slack_rad", r.yaw_slack_rad, {0, 3}, kInitial, "Largest yaw error that the trunk is turned by.");
  v.number("tilt_share", r.tilt_share, {0, 1}, kInitial, "Part of the ground's slope that the trunk follows.");
  v.check(r.least_height_m <= r.default_height_m && r.default_height_m <= r.largest_height_m, "default_height_m",
          "must lie between least_height_m and largest_height_m");
}

void declare(Visitor& v, TrunkWrenchParams& t) {
  number_of_all(v, "horizontal_gain_1_s2", t.position_gain_1_s2.head<2>(), {0, 1e4},
                "Force per horizontal position error and per kilogram of the robot.");
  v.number("height_gain_1_s2", t.position_gain_1_s2.z(), {0, 1e4}, kInitial, "The same of the height.");
  number_of_all(v, "horizontal_damping_1_s", t.velocity_gain_1_s.head<2>(), {0, 1e3},
                "Force per horizontal velocity error and per kilogram.");
  v.number("height_damping_1_s", t.velocity_gain_1_s.z(), {0, 1e3}, kInitial, "The same of the vertical velocity.");
  v.number("roll_gain_Nm_rad", t.attitude_gain_Nm_rad.x(), {0, 1e6}, "Moment per roll error.");
  v.number("pitch_gain_Nm_rad", t.attitude_gain_Nm_rad.y(), {0, 1e6}, "Moment per pitch error.");
  v.number("yaw_gain_Nm_rad", t.attitude_gain_Nm_rad.z(), {0, 1e6}, "Moment per yaw error.");
  v.number("roll_damping_Nms_rad", t.rate_gain_Nms_rad.x(), {0, 1e5}, "Moment per error of the roll rate.");
  v.number("pitch_damping_Nms_rad", t.rate_gain_Nms_rad.y(), {0, 1e5}, "Moment per error of the pitch rate.");
  v.number("yaw_damping_Nms_rad", t.rate_gain_Nms_rad.z(), {0, 1e5}, "Moment per error of the yaw rate.");
  v.number("height_integral_1_s3", t.height_integral_1_s3, {0, 1e4}, kInitial, "Removes the sag under unknown mass.");
  v.number("height_integral_limit_m_s2", t.height_integral_limit_m_s2, {0, 1e2}, kInitial,
           "Largest acceleration by that integral.");
  v.number("tilt_integral_1_s", t.tilt_integral_1_s, {0, 1e2}, kInitial,
           "Removes the tilt under an unknown load; relative to the gain.");
  v.number("tilt_integral_limit_Nm", t.tilt_integral_limit_Nm, {0, 1e4}, kInitial, "Largest moment by that integral.");
}

void declare(Visitor& v, PayloadParams& p) {
  v.flag("on", p.on, kInitial, "False: the legs support the model's weight, and integrals the rest.");
  v.number("time_constant_s", p.time_constant_s, {1e-2, 1e2}, kInitial, "Memory of the balance of forces.");
  v.number("moment_time_constant_s", p.moment_time_constant_s, {1e-2, 1e2}, kInitial,
           "Memory of the balance of moments: a tilting trunk moves it to and fro.");
  v.number("least_share", p.least_share, {-0.9, 0}, kInitial, "Least payload that is used, per mass of the robot.");
  v.number("largest_share", p.largest_share, {0, 2}, kInitial, "Largest payload that is used, per mass of the robot.");
  v.number("largest_rate_1_s", p.largest_rate_1_s, {1e-3, 1e2}, kInitial, "Of the payload that is used, likewise.");
  v.number("largest_shift_m", p.largest_shift_m, {0, 1}, kInitial,
           "Of the centre of mass that is used, along each axis of the trunk.");
  v.number("largest_shift_rate_m_s", p.largest_shift_rate_m_s, {1e-3, 1e2}, kInitial, "Speed of that shift.");
  v.number("push_gate_m_s2", p.push_gate_m_s2, {1e-2, 1e3}, kInitial,
           "A horizontal force per kilogram that the feet do not explain: above it the estimate rests.");
  v.number("push_time_constant_s", p.push_time_constant_s, {1e-3, 10}, kInitial, "Low-pass of that force.");
  v.number("shortfall_gate_m_s2", p.shortfall_gate_m_s2, {1e-2, 1e3}, kInitial,
           "Lift per kilogram that the feet are asked for and do not give: above it the estimate rests.");
  v.number("shortfall_time_constant_s", p.shortfall_time_constant_s, {1e-3, 10}, kInitial, "Low-pass of that lift.");
}

void declare(Visitor& v, ForceDistributionParams& f) {
  number_of_all(v, "horizontal_weight_1_N", f.weight.head<2>(), {0, 1e6}, "Weight of an error of horizontal force.");
  v.number("vertical_weight_1_N", f.weight[2], {0, 1e6}, kInitial, "The same of vertical force.");
  number_of_all(v, "tilt_weight_1_Nm", f.weight.segment<2>(3), {0, 1e6}, "The same of the moment in roll and pitch.");
  v.number("yaw_weight_1_Nm", f.weight[5], {0, 1e6}, kInitial, "The same of the moment in yaw.");
  v.number("force_weight", f.force_weight, {1e-12, 1e6}, kInitial, "Cost of forces, relative to the wrench's.");
  v.number("least_N", f.least_N, {0, 1e4}, kInitial, "Normal force that every foot on the ground keeps.");
  v.number("friction", f.friction, {1e-3, 5}, kInitial, "Friction of the pyramids; their edges reach 1.41 times it.");
}

void declare(Visitor& v, FootholdParams& f) {
  v.number("wider_m", f.wider_m, {0, 2}, kInitial, "How far the neutral foot stands outside the hip.");
  v.number("velocity_gain_s", f.velocity_gain_s, {0, 5}, kInitial, "Shift of a foothold per velocity error.");
  v.number("reach_m", f.reach_m, {1e-3, 5}, kInitial, "Largest distance from the neutral place, per axis.");
}

void declare(Visitor& v, SwingParams& s) {
  v.number("height_m", s.height_m, {0, 2}, kInitial, "Apex above the higher of lift-off and foothold.");
  v.number("forward_share", s.forward_share, {0.5, 1}, kInitial,
           "Share of the swing after which the foot is over its foothold.");
  v.number("press_m", s.press_m, {0, 1}, kInitial, "The path ends this far below the expected ground.");
  v.number("reach_speed_m_s", s.reach_speed_m_s, {1e-3, 10}, kInitial, "Downward speed after a swing without contact.");
  v.number("reach_depth_m", s.reach_depth_m, {0, 2}, kInitial, "Lowest place of that search below the path's end.");
}

void declare(Visitor& v, LegControllerParams& l) {
  number_of_all(v, "swing_stiffness_N_m", l.swing_stiffness_N_m.head<3>(), {0, 1e6}, "Of a swinging foot.");
  number_of_all(v, "swing_damping_Ns_m", l.swing_damping_Ns_m.head<3>(), {0, 1e5}, "Of a swinging foot.");
  number_of_all(v, "pose_stiffness_Nm_rad", l.pose_stiffness_Nm_rad.head<3>(), {0, 1e5}, "Of the joints in a pose.");
  number_of_all(v, "pose_damping_Nms_rad", l.pose_damping_Nms_rad.head<3>(), {0, 1e4}, "Of the joints in a pose.");
  number_of_all(v, "stop_damping_Nms_rad", l.stop_damping_Nms_rad.head<3>(), {0, 1e4},
                "Of the joints of a robot that has fallen.");
  v.number("haa_torque_limit_Nm", l.torque_limit_Nm.x(), {0, 1e5}, "Largest torque that HAA is asked for.");
  v.number("hfe_torque_limit_Nm", l.torque_limit_Nm.y(), {0, 1e5}, "Largest torque that HFE is asked for.");
  v.number("kfe_torque_limit_Nm", l.torque_limit_Nm.z(), {0, 1e5}, "Largest torque that KFE is asked for.");
  v.number("longest_leg_m", l.longest_leg_m, {0.01, 10}, "Hip to foot: references further away are shortened.");
  v.number("load_in_s", l.load_in_s, {0, 1}, kInitial, "Time in which a foot may take its load after touchdown.");
  v.number("load_out_s", l.load_out_s, {0, 1}, kInitial, "Time in which it gives its load up before lift-off.");
}

void declare(Visitor& v, ModeSequencerParams& m) {
  v.number("soft_start_s", m.soft_start_s, {1e-2, 60}, kInitial, "From the pose of the first tick to the folded one.");
  v.number("take_load_s", m.take_load_s, {1e-2, 60}, kInitial, "The weight goes from the pose to the feet or back.");
  v.number("folded_height_m", m.folded_height_m, {0.01, 10}, "Trunk's height at which a robot that sits down folds.");
  v.number("height_tolerance_m", m.height_tolerance_m, {1e-4, 1}, kInitial, "A height within this is reached.");
  v.number("settle_s", m.settle_s, {0, 60}, kInitial, "Stepping in place before a stop.");
  v.number("fallen_cosine", m.fallen_cosine, {-1, 1}, kInitial,
           "Cosine of the tilt from which on the robot counts as fallen.");
}

void declare(Visitor& v, JointGuardParams& g) {
  v.number("torque_share", g.torque_share, {0, 1}, kInitial,
           "A joint whose torque differs by less than this share of its limit follows.");
  v.number("haa_torque_share", g.haa_torque_share, {0, 1}, kInitial,
           "The same of HAA, which is still in much of a trot.");
  v.number("still_rad_s", g.still_rad_s, {1e-3, 10}, kInitial, "A joint whose mean velocity is larger is not dead.");
  v.number("dead_after_s", g.dead_after_s, {0, 10}, kInitial,
           "Time for which a joint neither follows nor moves until it is dead and the robot lies down.");
  v.number("dead_standing_after_s", g.dead_standing_after_s, {0, 10}, kInitial,
           "The same on four feet: adaptation finds a wide overlap in less.");
}

}  // namespace farrier::locomotion

namespace farrier::robot {

void declare(config::Visitor& v, LocomotionSection& s) {
  using config::Defaults;
  v.here(s.place);
  v.name("controller", s.controller, kLongestName, config::Default{""},
         "Controller that every joint has on a ground, by name; without it they have their own.");
  v.name("joint_estimator", s.joint_estimator, kLongestName, config::Default{""},
         "Estimator that every joint has on a ground, by name; without it they have their own.");
  v.number("folded_haa_rad", s.folded_haa_rad, {-8, 8}, "Angle of HAA in a robot that lies.");
  v.number("folded_hfe_rad", s.folded_hfe_rad, {-8, 8}, "The same of HFE, as a hind leg counts it.");
  v.number("folded_kfe_rad", s.folded_kfe_rad, {-8, 8}, "The same of KFE, as a hind leg counts it.");
  v.group("reference", s.params.reference, "Motion that the trunk may be asked for.");
  v.group("trunk", s.params.trunk, "Wrench on the trunk (Focchi 2016; Bledt 2018).");
  v.group("leg", s.params.leg, "Torques of one leg.");
  v.group("mode", s.params.mode, "Lying, standing up, trotting, stopping.");
  v.group("joint_guard", s.params.joint_guard, Defaults{}, "Joints that do not follow.");
  v.group("forces", s.params.forces, Defaults{}, "Distribution of the wrench over the feet.");
  v.group("payload", s.params.payload, Defaults{}, "Mass that the model does not know, from the forces at the feet.");
  v.group("foothold", s.params.foothold, Defaults{}, "Places of the feet (Raibert 1986).");
  v.group("swing", s.params.swing, Defaults{}, "Path of a swinging foot.");
  v.group("contact", s.params.contact, Defaults{}, "Contacts that overrule the schedule.");
  v.group("felt_touchdown", s.params.felt_touchdown, Defaults{},
          "Touchdowns that are felt before their plan change the joints' gains.");
  v.group("ground", s.params.ground, Defaults{}, "Ground under the last footholds.");
  v.group("estimator", s.params.estimator, Defaults{}, "Attitude, position and velocity from IMU and joints.");
}

}  // namespace farrier::robot
