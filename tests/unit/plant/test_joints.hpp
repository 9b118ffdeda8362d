#pragma once

#include "core/noise.hpp"
#include "plant/hydraulic_joint.hpp"

namespace farrier::plant::test {

inline constexpr double kPeriod_s = 1e-3;

/// HyQ leg cylinder: sizes of Hubacher (2014) Table A.1, oil, hose and valve of the robot.
inline ActuatorParams hyq_cylinder() {
  ActuatorParams p;
  p.area_a = 2.0106e-4;
  p.area_b = 1.2252e-4;
  p.stroke = 0.08;
  p.line_volume_m3 = 8.17e-6;
  p.bulk_modulus_Pa = 1.8181e9;
  p.valve_gain = 6.12e-6;
  p.valve_current_max_A = 0.01;
  p.supply_pressure_Pa = 160e5;
  p.return_pressure_Pa = 1e5;
  p.piston_mass = 0.3141;
  p.piston_damping = 700.0;
  p.stop_stiffness = 1e8;
  p.stop_damping = 1e4;
  return p;
}

/// Rig of Hubacher (2014) Tables A.1 and A.2, with 0.6 m of line holding what 3.8 mm bore holds.
inline ActuatorParams rig_cylinder() {
  ActuatorParams p = hyq_cylinder();
  p.line_volume_m3 = 6.8047e-6;
  p.bulk_modulus_Pa = 5.5e8;
  p.valve_gain = 1.6704e-6;
  p.supply_pressure_Pa = 125e5;
  p.return_pressure_Pa = 0.0;
  return p;
}

inline ActuatorParams hyq_rotary_motor() {
  ActuatorParams p = hyq_cylinder();
  p.area_a = p.area_b = 6.87e-6;
  p.stroke = 12.0e-6 / 6.87e-6;
  p.piston_mass = 1e-3;
  p.piston_damping = 1.0;
  p.stop_stiffness = 1e5;
  p.stop_damping = 30.0;
  return p;
}

inline LoadParams stance_load() { return {50.0, 500.0, 0.0, 0.0}; }
inline LoadParams swing_load() { return {2.5, 100.0, 0.0, 0.0}; }

inline HydraulicJoint joint_at_rest(const ActuatorParams& actuator, const LoadParams& load,
                                    double tolerance = HydraulicJoint::kDefaultTolerance) {
  const State middle = equilibrium(actuator, load, 0.5 * actuator.stroke, 0.0);
  return HydraulicJoint::create(actuator, load, middle, tolerance).value();
}

/// Seeded valve current with slow and fast parts, pulled towards the middle of the stroke.
class ValveNoise {
 public:
  ValveNoise(double slow_share, double fast_share)
      : slow_share_(slow_share), fast_share_(fast_share), slow_(2014, "test", "slow"), fast_(2014, "test", "fast") {}

  double next(const ActuatorParams& actuator, double position) {
    ++tick_;
    drift_ += 0.1 * (slow_.normal(tick_) - drift_);
    const double pull = 2.0 * (position / actuator.stroke - 0.5);
    return actuator.valve_current_max_A * (slow_share_ * drift_ + fast_share_ * fast_.normal(tick_) - pull);
  }

 private:
  double slow_share_;
  double fast_share_;
  NoiseStream slow_;
  NoiseStream fast_;
  double drift_ = 0.0;
  Tick tick_ = 0;
};

}  // namespace farrier::plant::test
