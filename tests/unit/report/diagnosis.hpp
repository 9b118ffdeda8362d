#pragma once

// Diagnoses that never were.

#include <cmath>
#include <numbers>

#include "run.hpp"
#include "report/diagnosis/diagnosis_result.hpp"

namespace farrier::report::testing {

inline plant::EffectId id_of(const char* name) {
  const plant::EffectId id = plant::find_effect(name);
  FARRIER_ENSURE(id < plant::kEffectCount, name);
  return id;
}

inline robot::Robot shipped(const std::string& name) {
  auto robot = robot::load_robot(std::string(FARRIER_ROBOTS) + "/" + name + ".yaml");
  FARRIER_ENSURE(robot.ok(), config::to_string(robot.error()).c_str());
  return std::move(robot).value();
}

inline robot::Robot rig() { return shipped("fc1d"); }

/// Bins of a driver from -1 to 1 in which the residual follows a curve.
template <class F>
diagnosis::Dependence dependence(F curve, const char* driver = "speed", double explained = 0.4) {
  diagnosis::Dependence bins{.driver = driver, .from = {}, .mean = {}, .deviation = {}, .explained = explained};
  for (int i = 0; i < 20; ++i) {
    bins.from.push_back(-1.0 + 0.1 * i);
    bins.mean.push_back(curve(-0.95 + 0.1 * i));
    bins.deviation.push_back(0.1);
  }
  return bins;
}

/// Two seconds of a force whose simulation is furthest off in the middle one.
inline diagnosis::ChannelReport force_channel() {
  diagnosis::ChannelReport c{.channel = diagnosis::Channel::kForce,
                             .name = "valve_and_oil",
                             .before = {0.02, 0.1, 0.4},
                             .after = {0.01, 0.03, 0.05},
                             .whiteness = 2.5,
                             .cross_correlation = 3.25,
                             .whiteness_after = 2.0,
                             .cross_correlation_after = 1.5,
                             .dependences = {dependence([](double x) { return x; }, "force", 0.05),
                                             dependence([](double x) { return x > 0.0 ? 1.0 : -1.0; })},
                             .frequency_Hz = {0.0, 1.0, 2.0, 4.0},
                             .spectrum_before = {1.0, 2.0, 8.0, 1.0},
                             .spectrum_after = {9.0, 1.0, 2.0, 3.0},
                             .measured = {},
                             .simulated_before = {},
                             .simulated_after = {}};
  for (int i = 0; i < 2000; ++i) {
    c.measured.push_back(100.0 * std::sin(2e-3 * std::numbers::pi * i));
    c.simulated_before.push_back(c.measured.back() + (i >= 600 && i < 1600 ? 20.0 : 1.0));
    c.simulated_after.push_back(c.measured.back() + 1.0);
  }
  return c;
}

inline diagnosis::Diagnosis diagnosis_of(diagnosis::Verdict verdict) {
  diagnosis::Diagnosis d{};
  d.judgement.verdict = verdict;
  d.channels = {force_channel()};
  d.nrmse_before = 0.4;
  d.nrmse_after = 0.1;
  d.ratio_low = 3.5;
  d.ratio_high = 4.5;
  d.judgement.left[0] = {12.0, 3.0, 0.3};
  return d;
}

/// Friction of the load, of 0.02 full push, and half as much gain by a valve that is slow.
inline std::vector<diagnosis::NamedEffect> two_effects() {
  return {{id_of("load_friction"), {0.02, 1.3, 0.01, plant::kPreslidingShare, 0.0}, 0.001, 0.67, 0.99},
          {id_of("valve_dynamics"), {0.004, 0.7}, 0.0002, 0.33, 0.9}};
}

/// One of them as a robot file has it.
inline plant::ActiveEffect active(const diagnosis::NamedEffect& effect, const robot::Joint& joint) {
  return plant::active_effect(effect.id, effect.fitted, plant::Scales(joint.actuator, joint.swing_load));
}

}  // namespace farrier::report::testing
