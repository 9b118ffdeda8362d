#pragma once

// A joint's piston that a mechanism moves as a leg in a trot does, with the estimator of its valve.

#include <cmath>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "control/law/effect_compensation.hpp"
#include "control/law/feedback_linearisation.hpp"
#include "core/noise.hpp"
#include "estimation/estimator.hpp"
#include "robot/joint_plant.hpp"
#include "robot/make_estimator.hpp"
#include "robot/wear.hpp"

namespace farrier::estimation::valve_flow_test {

inline constexpr double kPeriod_s = 1e-3;
inline constexpr int kSubsteps = 4;
inline constexpr double kPi = 3.141592653589793;

inline robot::Joint hfe() {
  const robot::Robot hyq = robot::load_robot(FARRIER_ROBOTS "hyq.yaml", {.on_ground = true}).value();
  return *hyq.find("lf_hfe");
}

/// A worn joint whose piston is moved as a leg in a trot is, under the force law of its file. The estimator reads what its
/// sensors do.
class MovedJoint {
 public:
  explicit MovedJoint(const robot::Wear& wear)
      : plant_(robot::make_plant(robot::worn(joint_, wear), joint_.stance_load).value()),
        law_(joint_.actuator, kGentle, home_, kPeriod_s),
        compensation_(joint_.effects, joint_.actuator, {kPeriod_s, joint_.noise.position, joint_.noise.velocity}),
        estimator_(robot::make_estimator(joint_, kPeriod_s, kDelay).value()) {}

  /// Moves by sines of 1.4 Hz and 3 Hz, in which the piston carries up to 400 N, at 1.4 Hz unless told.
  void run(double time_s, double amplitude_m = 0.007) {
    const Tick end = tick_ + static_cast<Tick>(std::lround(time_s / kPeriod_s));
    for (; tick_ < end; ++tick_) {
      const plant::JointReadings read = plant_.readings();
      const control::Measurement seen{read.position, read.velocity + joint_.noise.velocity * noise_.normal(2 * tick_),
                                      read.load_cell_force + joint_.noise.force * noise_.normal(2 * tick_ + 1)};
      const double t = static_cast<double>(tick_) * kPeriod_s;
      control::Measurement about_home = seen;
      about_home.position -= home_;
      const double reference = 400.0 * std::sin(2.0 * kPi * force_Hz_ * t);
      const double current_A = compensation_.current_A(law_.step(reference, about_home).valve_current_A, about_home);
      estimator_->take({.tick = tick_,
                        .state = {seen.position, seen.velocity, seen.force},
                        .current_A = current_A,
                        .phase = static_cast<int>(tick_ / 350 % 2),
                        .force_error = reference - seen.force,
                        .supply_pressure_Pa = told_supply_Pa_});
      for (int substep = 1; substep <= kSubsteps; ++substep) {
        const double then = t + kPeriod_s * substep / kSubsteps;
        const double a = 2.0 * kPi * 1.4, b = 2.0 * kPi * 3.0;
        plant_.follow(last_A_, std::nullopt,
                      {home_ + amplitude_m * (std::sin(a * then) + 0.4 * std::sin(b * then)),
                       amplitude_m * (a * std::cos(a * then) + 0.4 * b * std::cos(b * then))},
                      kPeriod_s / kSubsteps);
      }
      last_A_ = current_A;
    }
  }
  void wear(const robot::Wear& wear) {
    const robot::Joint worn = robot::worn(joint_, wear);
    ASSERT_TRUE(plant_.set_actuator(worn.actuator, worn.effects));
  }
  void weaken_supply(double pressure_Pa, bool told) {
    plant::ActuatorParams weak = joint_.actuator;
    weak.supply_pressure_Pa = pressure_Pa;
    ASSERT_TRUE(plant_.set_actuator(weak, joint_.effects));
    told_supply_Pa_ = told ? pressure_Pa : 0.0;
  }
  void press_with(double frequency_Hz) { force_Hz_ = frequency_Hz; }
  ModelEstimate estimate() const { return estimator_->estimate(); }
  double gain() const { return estimate().physics.valve_gain / joint_.actuator.valve_gain; }
  double overlap_percent() const { return 100.0 * estimate().physics.overlap_A / joint_.actuator.valve_current_max_A; }
  Estimator& estimator() { return *estimator_; }
  Tick tick() const { return tick_; }
  const robot::Joint& joint() const { return joint_; }

 private:
  static constexpr int kDelay = 1;
  // A mechanism that does not yield is a stiffer load than a robot.
  static constexpr control::FeedbackLinearisationGains kGentle{
      .force_1_s = 400.0, .integral_1_s2 = 0.0, .velocity_compensation = 0.9};

  robot::Joint joint_ = hfe();
  double home_ = joint_.linkage.position(joint_.home_angle_rad);
  plant::Joint plant_;
  control::FeedbackLinearisation law_;
  control::EffectCompensation compensation_;
  std::unique_ptr<Estimator> estimator_;
  NoiseStream noise_{1, "moved joint", "sensors"};
  double last_A_ = 0.0;
  double told_supply_Pa_ = 0.0;
  double force_Hz_ = 1.4;
  Tick tick_ = 0;
};

inline robot::Wear no_wear() { return robot::no_wear(hfe()); }

}  // namespace farrier::estimation::valve_flow_test
