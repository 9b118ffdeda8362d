#pragma once

// The nonlinear joint of Hubacher (2014), Table A.1, measured and driven: what the grey-box estimator is held against.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "core/noise.hpp"
#include "estimation/grey_box_estimator.hpp"
#include "plant/hydraulic_joint.hpp"
#include "plant/nominal.hpp"

namespace farrier::estimation::testing {

inline const Eigen::Vector3d kRigNoise(2e-6, 1.5e-3, 1.0);  // fc1d.yaml: m, m/s, N
inline constexpr double kHomePosition = 0.04;

inline plant::LoadParams cart(double mass_kg, double damping_Ns_m = 700.0) {
  return {.mass = mass_kg, .damping = damping_Ns_m, .stiffness = 21480, .equilibrium_position = kHomePosition};
}

inline JointScales rig_scales(const Eigen::Vector3d& noise, int delay_ticks = 0) {
  return {.state = {0.04, 1.2, 5000.0},
          .current_A = 0.01,
          .sensor_noise = noise,
          .home_position = kHomePosition,
          .period_s = 1e-3,
          .input_delay_ticks = delay_ticks};
}

/// A joint, its sensors and what drives its valve.
class Rig {
 public:
  Rig(const plant::ActuatorParams& actuator, const plant::LoadParams& load, const Eigen::Vector3d& noise,
      std::uint64_t seed = 1, int delay_ticks = 0)
      : joint_(plant::HydraulicJoint::create(actuator, load,
                                             plant::equilibrium(actuator, load, kHomePosition, 0.0)).value()),
        noise_(noise), seed_(seed), delay_ticks_(delay_ticks) {}

  /// White and uniform.
  static double rich(std::uint64_t seed, Tick tick, double amplitude_A) {
    return amplitude_A * (2.0 * NoiseStream(seed, "rig", "valve").uniform(tick) - 1.0);
  }
  /// 5 and 10 Hz.
  static double low(Tick tick, double amplitude_A) {
    const double turn = 2.0 * std::numbers::pi * 1e-3 * static_cast<double>(tick);
    return 0.5 * amplitude_A * (std::sin(5.0 * turn) + std::sin(10.0 * turn));
  }

  void becomes(const plant::LoadParams& load) { ASSERT_TRUE(joint_.set_load(load)); }

  /// Measures, then moves on by a tick with `current_A`, and `push_N` on the load.
  JointSample next(double current_A, int phase = 0, double push_N = 0.0) {
    JointSample sample{.tick = tick_, .state = {}, .current_A = current_A, .phase = phase};
    const plant::State& s = joint_.state();
    sample.state << s.position, s.velocity, joint_.load_cell_force();
    for (int i = 0; i < 3; ++i) {
      sample.state(i) += noise_(i) * NoiseStream(seed_, "rig", std::to_string(i)).normal(tick_);
    }
    currents_[2] = currents_[1];
    currents_[1] = currents_[0];
    currents_[0] = current_A;
    (void)joint_.step(currents_[delay_ticks_], push_N, 1e-3);
    ++tick_;
    return sample;
  }

  Tick tick() const { return tick_; }

 private:
  plant::HydraulicJoint joint_;
  Eigen::Vector3d noise_;
  std::uint64_t seed_;
  int delay_ticks_;
  double currents_[3] = {};
  Tick tick_ = 0;
};

inline GreyBoxEstimator grey_box(const Eigen::Vector3d& noise, double light_kg = 1.0, double heavy_kg = 100.0,
                                 const EstimatorParams& params = {}, int delay_ticks = 0) {
  return GreyBoxEstimator::create(params, rig_scales(noise, delay_ticks), plant::nominal_cylinder(),
                                  {cart(light_kg), cart(heavy_kg)}).value();
}

inline bool has_flag(const ModelEstimate& estimate, EstimateFlag flag) {
  return (estimate.flags & static_cast<std::uint32_t>(flag)) != 0;
}

}  // namespace farrier::estimation::testing
