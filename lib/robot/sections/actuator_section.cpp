#include "robot/sections/actuator_section.hpp"

#include <array>

namespace farrier::robot {

using config::Default;
using config::Defaults;
using config::kInitial;
using config::Option;
using config::Visitor;

void declare(Visitor& v, Pump& pump) {
  v.number("flow_m3_s", pump.flow_m3_s, {0, 1},
           "Flow of the pump. Beyond supply_pressure_Pa a relief valve spills it.");
  v.number("hose_compliance_m3_Pa", pump.hose_compliance_m3_Pa, {1e-14, 1e-9}, kInitial,
           "Oil that manifold and hoses take per pressure.");
  v.number("null_leakage_m3_s_Pa", pump.null_leakage_m3_s_Pa, {0, 1e-9}, kInitial,
           "Oil that each valve passes to the reservoir while it is shut, per pressure.");
}

void declare(Visitor& v, Accumulator& accumulator) {
  v.number("volume_m3", accumulator.volume_m3, {0, 1}, "Volume of the gas at its precharge.");
  v.number("precharge_Pa", accumulator.precharge_Pa, {1e5, 5e7}, "Pressure of the gas while no oil is in.");
  v.number("polytropic_exponent", accumulator.polytropic_exponent, {1.001, 2}, kInitial, "n of the gas, p V^n.");
}

void declare(Visitor& v, Supply& s) {
  v.number("supply_pressure_Pa", s.supply_pressure_Pa, {1e5, 5e7}, "Pressure of the pump at the valves, p_s.");
  v.number("return_pressure_Pa", s.return_pressure_Pa, {0, 1e7}, kInitial, "Pressure of the reservoir, p_t.");
  v.number("bulk_modulus_Pa", s.bulk_modulus_Pa, {1e7, 5e9}, "Effective bulk modulus of oil and lines, beta_e.");
  v.number("laminar_pressure_Pa", s.laminar_pressure_Pa, {1, 1e6}, kInitial,
           "Pressure drop below which an orifice is laminar.");
  v.group("pump", s.pump, "Pump that all joints of a robot on a ground share; absent: a constant pressure.");
  v.group("accumulator", s.accumulator, "Accumulator beside the pump; absent: there is none.");
  v.number("low_share", s.low_share, {0, 1}, kInitial,
           "With a pump: below this share of supply_pressure_Pa the supply is low, and an event says so.");
  v.number("slow_share", s.slow_share, {0, 1}, kInitial, "Below this share a robot that trots slows down.");
  v.number("recovered_share", s.recovered_share, {0, 1}, kInitial,
           "From this share on it has recovered, and a robot that slowed down speeds up again.");
  v.number("lie_share", s.lie_share, {0, 1}, kInitial,
           "Below this share, and without flow of the pump, the robot lies down.");
  v.number("stand_after_s", s.stand_after_s, {0, 100}, kInitial,
           "Time for which the supply is low before a robot that trots stands.");
  v.number("slowest", s.slowest, {0, 1}, kInitial,
           "Least factor on the commanded velocities of a robot that slows down.");
  v.check(s.low_share <= s.slow_share, "slow_share", "must not be below low_share");
  v.check(s.slow_share <= s.recovered_share, "recovered_share", "must not be below slow_share");
  v.check(s.lie_share <= s.low_share, "lie_share", "must not be above low_share");
  v.check(!s.accumulator || s.pump, "accumulator", "needs pump: give it, or leave the accumulator out");
  v.check(s.return_pressure_Pa < s.supply_pressure_Pa, "return_pressure_Pa", "must be below supply_pressure_Pa");
}

void declare(Visitor& v, Valve& valve) {
  v.number("gain_m3_s_AsqrtPa", valve.gain_m3_s_AsqrtPa, {1e-9, 1e-3},
           "Flow per current and root of pressure drop, K_v: Q = K_v u sqrt(dp).");
  v.number("current_max_A", valve.current_max_A, {1e-4, 1}, "Current of the full-open valve; the controller's limit.");
  v.moved("deadband_percent", "give effects.<joint>.valve_deadband.half_width_A, in A");
  v.moved("spool", "give effects.<joint>.valve_dynamics with natural_frequency_rad_s and damping");
}

void declare(Visitor& v, Stops& stops) {
  v.number("stiffness_N_m", stops.stiffness_N_m, {1e4, 1e10}, "Stiffness of the contact with an end of the cylinder.");
  v.number("damping_Ns_m", stops.damping_Ns_m, {0, 1e7}, "Damping of that contact.");
}

void declare(Visitor& v, CylinderNoise& noise) {
  v.number("position_m", noise.position_m, {0, 1e-2}, "Standard deviation of the measured piston position.");
  v.number("velocity_m_s", noise.velocity_m_s, {0, 1}, "Standard deviation of the measured piston velocity.");
  v.number("force_N", noise.force_N, {0, 1e3}, "Standard deviation of the load cell.");
}

void declare(Visitor& v, Cylinder& c) {
  v.number("bore_m", c.bore_m, {2e-3, 0.5}, "Diameter of the piston, D_p.");
  v.number("rod_m", c.rod_m, {0, 0.5}, "Diameter of the rod, D_r; 0 for a rod on neither side.");
  v.number("stroke_m", c.stroke_m, {1e-3, 5}, "Stroke, L_c.");
  v.number("piston_mass_kg", c.piston_mass_kg, {0, 100}, "Piston and rod, m_p.");
  v.number("piston_damping_Ns_m", c.piston_damping_Ns_m, {0, 1e6}, "Viscous friction of the piston, d_p.");
  v.number("rated_force_N", c.rated_force_N, {1, 1e6}, "Force the cylinder and its mounting are made for.");
  v.number("velocity_norm_m_s", c.velocity_norm_m_s, {1e-3, 100}, kInitial, "Velocity that counts as 1 (3.52).");
  v.number("force_norm_N", c.force_norm_N, {1, 1e6}, kInitial, "Force that counts as 1 (3.52).");
  v.group("stops", c.stops, "Contact at both ends of the stroke.");
  v.group("noise", c.noise, "Sensor noise.");
  v.group("sensors", c.sensors, "How sensors convert and filter; absent, a sample is the truth with its noise.");
  v.check(c.rod_m < c.bore_m, "rod_m", "must be below bore_m");
}

void declare(Visitor& v, RotaryMotor& m) {
  v.here(m.place);
  v.number("displacement_m3_rad", m.displacement_m3_rad, {1e-9, 1e-2}, "Volume per angle, the same on both sides.");
  v.number("travel_rad", m.travel_rad, {1e-2, 6.3}, "Angle from stop to stop.");
  v.number("rated_torque_Nm", m.rated_torque_Nm, {1e-2, 1e5}, "Torque the motor is made for.");
  v.name("like_cylinder", m.like_cylinder, kLongestName,
         "Actuator whose friction, inertia, stops, noise and normalisation it has, seen through a lever.");
  v.names("lever_joints", m.lever_joints, "Joints whose levers at home are averaged to that lever.");
}

void declare(Visitor& v, Actuator& a) {
  v.here(a.place);
  v.name("valve", a.valve, kLongestName, "Its valve, by name.");
  v.number("line_volume_m3", a.line_volume_m3, {1e-9, 1e-2}, "Dead volume of each chamber with its hose, V_pl.");
  v.group("lines", a.lines, "Oil inertia in the two hoses; absent, they are volume alone.");
  v.group("cylinder", a.cylinder, "A cylinder; or else rotary_motor.");
  v.group("rotary_motor", a.rotary_motor, "A rotary vane motor; or else cylinder.");
  v.check(a.cylinder.has_value() != a.rotary_motor.has_value(), "", "give either cylinder or rotary_motor");
}

void declare(Visitor& v, Triangle& t) {
  v.number("side_a_m", t.side_a_m, {1e-3, 10}, "Joint to one end of the cylinder.");
  v.number("side_b_m", t.side_b_m, {1e-3, 10}, "Joint to the other end.");
  v.number("angle_at_zero_rad", t.angle_at_zero_rad, {1e-3, 3.14}, "Angle between the two at joint angle 0.");
  v.flag("opens_with_angle", t.opens_with_angle, "Whether that angle grows with the joint's (on a hind leg).");
  v.number("retracted_length_m", t.retracted_length_m, {1e-3, 20}, "Length of the cylinder at position 0.");
}

void declare(Visitor& v, Direct& d) {
  v.number("lever", d.lever, {1e-3, 1e3}, kInitial, "Actuator position per joint angle: m/rad, or 1 for a motor.");
  v.number("zero_angle_rad", d.zero_angle_rad, {-10, 10}, kInitial, "Joint angle at actuator position 0.");
}

void declare(Visitor& v, LinkageSection& l) {
  v.here(l.place);
  v.group("triangle", l.triangle, "A cylinder across the joint; or else direct.");
  v.group("direct", l.direct, "A constant ratio; or else triangle.");
  v.check(l.triangle.has_value() != l.direct.has_value(), "", "give either triangle or direct");
}

void declare(Visitor& v, CylinderLoad& l) {
  v.number("mass_kg", l.mass_kg, {0.01, 1000}, "Mass the piston moves, m_l.");
  v.number("damping_Ns_m", l.damping_Ns_m, {0, 1e5}, "Viscous friction of the load, d_l.");
  v.number("stiffness_N_m", l.stiffness_N_m, {0, 1e7}, kInitial, "Springs against the base, C = k_1 + k_2.");
  v.number("equilibrium_position_m", l.equilibrium_position_m, {-10, 10}, kInitial,
           "Piston position where those are slack.");
  v.moved("friction",
          "give effects.<joint>.load_friction with coulomb_N, breakaway_ratio (static over Coulomb friction) and "
          "stribeck_velocity_m_s");
}

void declare(Visitor& v, LegLoad& l) {
  v.here(l.place);
  v.name("damping_like", l.damping_like, kLongestName,
         "Load whose friction in swing it has, seen through the motor's lever.");
}

void declare(Visitor& v, Load& l) {
  v.here(l.place);
  v.group("swing", l.swing, "With the leg in the air; with stance, or else leg_about_haa or rotary.");
  v.group("stance", l.stance, "With the foot on the ground.");
  v.group("leg_about_haa", l.leg_about_haa,
          "The leg's own inertia about its HAA axis at home, in swing and stance; for a rotary motor.");
  v.group("rotary", l.rotary, "Swing and stance of an electric joint.");
  const int kinds = (l.swing ? 1 : 0) + (l.leg_about_haa ? 1 : 0) + (l.rotary ? 1 : 0);
  v.check(l.swing.has_value() == l.stance.has_value() && kinds == 1, "",
          "give either swing and stance, or leg_about_haa, or rotary");
}

void declare(Visitor& v, PidSection& p) {
  const control::PidGains standard;
  v.number("proportional", p.proportional, {0, 1e3}, Default{standard.proportional},
           "Share of the full-open valve per force error over the force that counts as 1.");
  v.number("integral_1_s", p.integral_1_s, {0, 1e6}, Default{standard.integral_1_s},
           "Likewise on the integral of that error; 0 is off.");
  v.number("derivative_s", p.derivative_s, {0, 10}, Default{standard.derivative_s},
           "Likewise on its filtered derivative; 0 is off.");
  v.number("derivative_filter_Hz", p.derivative_filter_Hz, {1, 1e4}, Default{standard.derivative_filter_Hz},
           "Corner of the filter on the derivative.");
}

void declare(Visitor& v, FlowInversionSection& f) {
  const control::FlowInversionGains standard;
  v.number("error_share", f.error_share, {1e-3, 1}, Default{standard.error_share},
           "Share of the force error that is made up for within a tick.");
  v.number("reference_share", f.reference_share, {0, 1}, Default{standard.reference_share},
           "Share of the reference's last change that is expected again in the next tick; 0 is off.");
  v.number("force_share", f.force_share, {1e-3, 1}, Default{standard.force_share},
           "Share of what was measured beyond the predicted force that is believed.");
  v.number("velocity_share", f.velocity_share, {1e-3, 1}, Default{standard.velocity_share},
           "Likewise of the velocity.");
  v.number("flow_share", f.flow_share, {0, 1}, Default{standard.flow_share},
           "Share of that force that counts as a flow nobody asked for: the integral action.");
  v.number("load_share", f.load_share, {0, 1}, Default{standard.load_share},
           "Share of that velocity that counts as a force on the load.");
}

void declare(Visitor& v, Controller& c) {
  constexpr std::array kForms = {Option<control::Form>{"full_state", control::Form::kFullState},
                                 Option<control::Form>{"compliant", control::Form::kCompliant}};
  constexpr std::array kMethods = {
      Option<control::DesignMethod>{"lqr", control::DesignMethod::kLqr},
      Option<control::DesignMethod>{"pole_placement", control::DesignMethod::kPolePlacement}};
  control::LqrWeights& w = c.design.weights;
  control::PolePlacement& p = c.design.poles;
  control::FeedbackLinearisationGains& f = c.feedback_linearisation;
  v.choice<control::Kind>("kind", c.kind, kControllerKinds, kInitial,
                          "lqr runs the designs that come over the bus; feedback_linearisation inverts the flow law, "
                          "as HyQ ran it (9.2.5), and takes the last three numbers of this section; pid runs the gains "
                          "of that group; flow_inversion inverts it with the physics that come over the bus. Those "
                          "three use neither form nor weights.");
  v.choice<control::DesignMethod>("design", c.design.method, kMethods, Default{control::DesignMethod::kLqr},
                                  "How the gains of kind lqr are found: by the weights, or by placing the poles.");
  v.choice<control::Form>("form", c.form, kForms,
                          "full_state needs a load spring; compliant leaves the position out of the design (9.2.4).");
  v.number("integral_weight", w.integral, {0, 1e6}, "On the summed force error (7.9).");
  v.number("position_weight", w.position, {0, 1e6}, "On the position (7.9); unused by the compliant form.");
  v.number("velocity_weight", w.velocity, {0, 1e6}, "On the velocity (7.9).");
  v.number("force_weight", w.force, {0, 1e6}, "On the force (7.9).");
  v.number("input_weight", w.input, {1e-6, 1e6}, "On the valve current (7.10).");
  v.number("integral_factor", w.integral_factor, {1e-3, 50}, "Multiplies the integral gain at run time, xi (7.11).");
  v.number("feed_forward_factor", w.feed_forward_factor, {0, 2}, kInitial, "Multiplies the feed-forward; 0 is off.");
  v.number("pole_bandwidth_rad_s", p.bandwidth_rad_s, {1, 3e3}, Default{p.bandwidth_rad_s},
           "pole_placement: natural frequency of the pair that force and integral share; below pi over the period.");
  v.number("pole_damping", p.damping, {0.1, 5}, Default{p.damping}, "pole_placement: damping of that pair.");
  v.flag("equalise_filters", c.equalise_filters, kInitial,
         "The joint's node filters position, velocity or force until all lag alike; for sensors that are filtered "
         "differently (10.2).");
  v.group("pid", c.pid, Defaults{}, "pid: fixed gains.");
  v.group("flow_inversion", c.flow_inversion, Defaults{},
          "flow_inversion: what its observer and its law are tuned by.");
  v.number("force_rate_1_s", f.force_1_s, {0, 1e5}, Default{f.force_1_s},
           "feedback_linearisation: rate at which a force error is to vanish.");
  v.number("integral_rate_1_s2", f.integral_1_s2, {0, 1e8}, Default{f.integral_1_s2},
           "feedback_linearisation: on the integral of the force error; 0 is off.");
  v.number("velocity_compensation", f.velocity_compensation, {0, 2}, Default{f.velocity_compensation},
           "feedback_linearisation: share of the piston's own flow that the valve makes up for.");
  v.number("velocity_lead_s", f.velocity_lead_s, {0, 0.1}, Default{f.velocity_lead_s},
           "feedback_linearisation: time by which the velocity is led before that, for valve and bus; 0 is off.");
  v.number("observer_1_s", f.observer_1_s, {0, 1e4}, Default{f.observer_1_s},
           "feedback_linearisation: bandwidth of the observer of what the flow law does not explain; 0 is off.");
  v.number("swing_gain", f.swing_gain, {0.1, 10}, Default{f.swing_gain},
           "feedback_linearisation: factor on the currents of swing.");
}

}  // namespace farrier::robot
