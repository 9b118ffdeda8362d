// The machine behind blind trials is itself held to what its equations promise.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "trials/truth/driver.hpp"
#include "trials/truth/record.hpp"
#include "trials/truth/truth.hpp"

namespace farrier::truth {
namespace truth_test {

constexpr double kPeriod_s = 1e-3;
constexpr double kDuration_s = 2.0;

const robot::Joint& joint(const std::string& robot_name, const std::string& joint_name) {
  static std::map<std::string, robot::Robot> robots;
  if (!robots.contains(robot_name)) {
    auto loaded = robot::load_robot(std::string(FARRIER_ROBOTS) + "/" + robot_name + ".yaml");
    FARRIER_ENSURE(loaded.ok(), "a shipped robot loads");
    robots.emplace(robot_name, std::move(loaded).value());
  }
  const robot::Joint* found = robots.at(robot_name).find(joint_name);
  FARRIER_ENSURE(found != nullptr, "a shipped robot has its joints");
  return *found;
}
const robot::Joint& piston() { return joint("fc1d", "fc1d"); }
const robot::Joint& hip() { return joint("hyq", "lf_haa"); }

constexpr Excitation kAll[] = {Excitation::kMultisine, Excitation::kRandomSteps, Excitation::kForceTracking};

Plan plan_with(std::vector<Hidden> hidden, std::uint64_t seed = 1, Excitation excitation = Excitation::kMultisine) {
  return {seed, excitation, std::move(hidden), kDuration_s};
}

Trial trial(const robot::Joint& of, const Plan& plan) {
  auto generated = generate(of, kPeriod_s, plan);
  EXPECT_TRUE(generated.ok()) << (generated ? "" : generated.error().message);
  return generated ? std::move(generated).value() : Trial{};
}

double rms(const std::vector<double>& x) {
  double sum = 0.0;
  for (const double value : x) sum += value * value;
  return std::sqrt(sum / static_cast<double>(x.size()));
}

double rms_difference(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> difference;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) difference.push_back(x[i] - y[i]);
  return rms(difference);
}

/// Changes of the signals in units of their noise, added.
double change(const robot::Joint& of, const Samples& x, const Samples& y) {
  return rms_difference(x.position, y.position) / of.noise.position +
         rms_difference(x.velocity, y.velocity) / of.noise.velocity +
         rms_difference(x.force, y.force) / of.noise.force + rms_difference(x.pressure_a_Pa, y.pressure_a_Pa) / 2e3 +
         rms_difference(x.supply_pressure_Pa, y.supply_pressure_Pa) / 2e3;
}

/// Readings of a machine under a given current, without noise.
std::vector<Reading> replay(const Machine& machine, const std::vector<double>& current_A, int substeps) {
  Simulator simulator(machine, {kPeriod_s, 0, substeps}, 1, "replay");
  std::vector<Reading> out;
  for (const double current : current_A) {
    out.push_back(simulator.read());
    simulator.tick(current);
  }
  return out;
}

Machine machine_with(const robot::Joint& of, const std::string& effect, int magnitude) {
  Machine machine = machine_of(of, 1);
  const Extents extents{mechanics_of(of).push,
                        of.actuator.stroke / 0.08,
                        kPeriod_s,
                        kDuration_s,
                        0.005,
                        3e-5,
                        0.15 * of.actuator.stroke,
                        0.15 * of.actuator.stroke,
                        0.05 * mechanics_of(of).push,
                        0.05 * of.actuator.stroke};
  const Entry& entry = *find_entry(effect);
  entry.hide(machine, entry.sizes[magnitude], extents, Chance(1, of.name, effect));
  return machine;
}

std::vector<std::string> all_effects() {
  std::vector<std::string> names = known_effects();
  for (const std::string& name : outside_effects()) names.push_back(name);
  return names;
}

TEST(Truth, HasTheEffectsOfTheLibraryAndOthers) {
  EXPECT_EQ(known_effects().size(), 25u);
  EXPECT_GE(outside_effects().size(), 7u);
  for (const std::string& name : all_effects()) EXPECT_NE(headline(name), "") << name;
}

TEST(Truth, RefusesWhatItCannotHide) {
  EXPECT_FALSE(generate(piston(), kPeriod_s, plan_with({{"gremlin", 0}})).ok());
  EXPECT_FALSE(generate(piston(), kPeriod_s, plan_with({{"backlash", 3}})).ok());
  EXPECT_FALSE(generate(piston(), kPeriod_s, plan_with({{"backlash", 0}, {"backlash", 1}})).ok());
  EXPECT_FALSE(generate(piston(), 0.1, plan_with({})).ok());
  EXPECT_FALSE(generate(joint("fc1d_real", "fc1d"), kPeriod_s, plan_with({})).ok());
}

TEST(Truth, TheSamePlanGivesTheSameNumbers) {
  const Plan plan = plan_with({{"load_friction", 1}, {"random_disturbance_force", 0}}, 5, Excitation::kForceTracking);
  const Trial first = trial(hip(), plan), second = trial(hip(), plan);
  EXPECT_EQ(first.samples.force, second.samples.force);
  EXPECT_EQ(first.samples.valve_current_A, second.samples.valve_current_A);
  EXPECT_EQ(first.answers[0].value, second.answers[0].value);
}

// A wrong load cell under open loop changes nothing but its own signal, and that by the offset, digit for digit.
TEST(Truth, TwinsShareMachineExcitationAndNoise) {
  const Trial plain = trial(piston(), plan_with({}));
  const Trial twin = trial(piston(), plan_with({{"force_sensor_offset", 1}}));
  EXPECT_EQ(plain.samples.valve_current_A, twin.samples.valve_current_A);
  EXPECT_EQ(plain.samples.position, twin.samples.position);
  EXPECT_EQ(plain.samples.pressure_a_Pa, twin.samples.pressure_a_Pa);
  for (std::size_t k = 0; k < plain.samples.force.size(); ++k) {
    ASSERT_NEAR(twin.samples.force[k] - plain.samples.force[k], twin.answers[0].value, 0.251);
  }
}

TEST(Truth, AnEffectIsTheSameWhateverElseIsHidden) {
  const Trial alone = trial(piston(), plan_with({{"backlash", 1}}));
  const Trial together = trial(piston(), plan_with({{"load_mass", 2}, {"backlash", 1}}));
  EXPECT_EQ(alone.answers[0].value, together.answers[1].value);
}

// At no tick by more than a tenth of a sensor's noise.
TEST(Truth, HalvingTheStepChangesLessThanSensorsSee) {
  for (const robot::Joint* of : {&piston(), &hip()}) {
    std::vector<double> current = trial(*of, plan_with({}, 1, Excitation::kRandomSteps)).samples.valve_current_A;
    current.erase(current.begin(), current.begin() + static_cast<long>(current.size() / 2));
    for (const std::string& name : all_effects()) {
      const Machine machine = machine_with(*of, name, 2);
      const std::vector<Reading> coarse = replay(machine, current, step_count(machine, kPeriod_s));
      const std::vector<Reading> fine = replay(machine, current, 2 * step_count(machine, kPeriod_s));
      double position = 0.0, velocity = 0.0, force = 0.0;
      for (std::size_t k = 0; k < coarse.size(); ++k) {
        position = std::max(position, std::abs(coarse[k].position - fine[k].position) / of->noise.position);
        velocity = std::max(velocity, std::abs(coarse[k].velocity - fine[k].velocity) / of->noise.velocity);
        force = std::max(force, std::abs(coarse[k].force - fine[k].force) / of->noise.force);
      }
      EXPECT_LT(position, 0.1) << of->name << ' ' << name;
      EXPECT_LT(velocity, 0.1) << of->name << ' ' << name;
      EXPECT_LT(force, 0.1) << of->name << ' ' << name;
    }
  }
}

/// Flow into chamber a of a piston at rest, m^3/s.
double flow_a(const Machine& m, const Vector& x, double current_A, double time_s = 0.0) {
  Vector dx;
  differentiate(m, time_s, x, {current_A, 0.0}, dx);
  return dx[kPa] / m.bulk_modulus_Pa * (m.line_volume_m3 + m.area_a * x[kX]);
}

TEST(Truth, APlainValveGivesTheRootOfTheDropAtEachPort) {
  const Machine m = machine_of(piston(), 1);
  Vector x = at_rest(m);
  for (const double share : {0.03, 0.2, 1.0}) {
    const double current = share * m.current_max_A;
    for (const double pressure : {0.1, 0.5, 0.9}) {
      x[kPa] = pressure * m.supply_Pa;
      const double in = m.valve_gain * current * std::sqrt(m.supply_Pa - x[kPa]);
      const double out = m.valve_gain * current * std::sqrt(x[kPa] - m.return_Pa);
      EXPECT_NEAR(flow_a(m, x, current), in, 0.01 * in);
      EXPECT_NEAR(flow_a(m, x, -current), -out, 0.01 * out);
    }
  }
}

TEST(Truth, ASmallPortHalvesTheSquareOfTheFlowAtItsCurrent) {
  Machine m = machine_of(piston(), 1);
  const Vector x = at_rest(m);
  const double wide = flow_a(m, x, 0.004);
  m.port_current_A = 0.004;
  EXPECT_NEAR(flow_a(m, x, 0.004), wide / std::sqrt(2.0), 0.01 * wide);
  EXPECT_NEAR(flow_a(m, x, 0.0004), 0.1 * wide / std::sqrt(1.01), 0.001 * wide);
}

// p + beta ln V of a shut chamber is its oil.
TEST(Truth, ShutChambersKeepTheirOil) {
  Machine m = machine_of(piston(), 1);
  m.overlap_A = m.current_max_A;
  m.external_force = 500.0;
  const auto oil_a = [&](const Vector& x) {
    return x[kPa] + m.bulk_modulus_Pa * std::log(m.line_volume_m3 + m.area_a * x[kX]);
  };
  Simulator simulator(m, {kPeriod_s, 0, 50}, 1, "shut");
  const double before = oil_a(simulator.state()), rest = simulator.state()[kX];
  double moved = 0.0;
  for (int k = 0; k < 300; ++k) {
    simulator.tick(0.0);
    moved = std::max(moved, simulator.state()[kX] - rest);
  }
  EXPECT_GT(moved, 1e-4);
  EXPECT_NEAR(oil_a(simulator.state()), before, 2e-4 * m.supply_Pa);  // the lands' round edges
}

TEST(Truth, WhatLeaksOutOfOneChamberEntersTheOther) {
  Machine m = machine_of(piston(), 1);
  m.overlap_A = m.current_max_A;
  m.leakage_m3_s_Pa = 1e-13;
  const Vector x = at_rest(m);
  Vector dx;
  differentiate(m, 0.0, x, {0.0, 0.0}, dx);
  const double in_a = dx[kPa] * (m.line_volume_m3 + m.area_a * x[kX]);
  const double in_b = dx[kPb] * (m.line_volume_m3 + m.area_b * (m.stroke - x[kX]));
  EXPECT_GT(in_a, 0.0);  // a cylinder at rest has the higher pressure at its rod
  EXPECT_NEAR(in_a, -in_b, 1e-3 * in_a);
}

TEST(Truth, EffectsActWhereTheyShould) {
  const Machine plain = machine_of(piston(), 1);
  const Vector x = at_rest(plain);
  const double flow = flow_a(plain, x, 0.002);
  EXPECT_LT(flow_a(machine_with(piston(), "valve_deadband", 2), x, 0.002), 0.8 * flow);
  Machine tilted = plain;
  tilted.asymmetry = 0.3;
  EXPECT_NEAR(flow_a(tilted, x, 0.002), 1.3 * flow, 1e-3 * flow);
  EXPECT_LT(flow_a(machine_with(piston(), "gain_drift", 2), x, 0.002, kDuration_s), 0.75 * flow);
  EXPECT_LT(flow_a(machine_with(piston(), "air_entrainment", 2), x, 0.002), 0.8 * flow);  // of what is compressed

  Vector moving = x, dx;
  moving[kX] += 0.1 * plain.stroke;
  moving[kV] = 0.05;
  const double cell = differentiate(plain, 0.0, moving, {0.0, 0.0}, dx).cell_force;
  const double resists = plain.load_mass * dx[kV] + plain.load_damping * moving[kV] +
                         plain.load_stiffness * (moving[kX] - plain.spring_rest);
  EXPECT_NEAR(cell, resists, 1e-9 * std::abs(resists));
  const double slowing = dx[kV];
  differentiate(machine_with(piston(), "spring_hardening", 2), 0.0, moving, {0.0, 0.0}, dx);
  EXPECT_LT(dx[kV], slowing);
  for (const char* friction : {"load_friction", "piston_friction"}) {
    const Machine m = machine_with(piston(), friction, 2);
    const Contact& c = m.load_contact.coulomb > 0.0 ? m.load_contact : m.piston_contact;
    Vector sliding = moving;
    sliding[kLoadBristle] = sliding[kPistonBristle] = c.presliding * c.coulomb / c.breakaway;
    differentiate(m, 0.0, sliding, {0.0, 0.0}, dx);
    EXPECT_NEAR((slowing - dx[kV]) * (m.piston_mass + m.load_mass), c.coulomb, 1e-3 * c.coulomb) << friction;
  }
}

TEST(Truth, PlainRunsUseTheStrokeAndStayInsideIt) {
  for (const robot::Joint* of : {&piston(), &hip()}) {
    for (const Excitation excitation : kAll) {
      for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Samples samples = trial(*of, plan_with({}, seed, excitation)).samples;
        const auto [low, high] = std::minmax_element(samples.position.begin(), samples.position.end());
        EXPECT_GT(*low, 0.25 * of->actuator.stroke);
        EXPECT_LT(*high, 0.75 * of->actuator.stroke);
        EXPECT_GT(*high - *low, 0.04 * of->actuator.stroke);
        EXPECT_GT(rms(samples.force), 20.0 * of->noise.force);
        EXPECT_GT(*std::min_element(samples.pressure_a_Pa.begin(), samples.pressure_a_Pa.end()), 1e5);
      }
    }
  }
}

TEST(Truth, LargerEffectsChangeMore) {
  const Samples plain = trial(piston(), plan_with({})).samples;
  for (const std::string& name : all_effects()) {
    double before = 0.1;
    for (int magnitude = 0; magnitude < 3; ++magnitude) {
      const Trial hidden = trial(piston(), plan_with({{name, magnitude}}));
      const double now = change(piston(), plain, hidden.samples);
      EXPECT_GT(now, before) << name << ' ' << magnitude;
      before = now;
    }
  }
}

}  // namespace truth_test
}  // namespace farrier::truth
