// The engine of the diagnosis: simulations of both sides, their derivatives, fits.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "core/noise.hpp"
#include "diagnosis/judge/fit.hpp"
#include "diagnosis/model/joint_model.hpp"
#include "diagnosis/model/joint_simulator.hpp"
#include "tests/unit/diagnosis/derivatives.hpp"
#include "tests/unit/diagnosis/rig.hpp"

namespace farrier::diagnosis {
namespace fit_test {

/// The rig under random steps of the current.
Recording recorded(double duration_s, double mass_factor = 1.0) {
  plant::LoadParams load = rig().swing_load;
  load.mass *= mass_factor;
  const NoiseStream draw(7, "diagnosis_fit_test", "current");
  return recorded_rig(static_cast<int>(duration_s * 1000), load, [&](int k) {
    return (2.0 * draw.uniform(k / 60) - 1.0) * ((k / 1000) % 2 == 0 ? 0.5e-3 : 2e-3);
  });
}

TEST(SideModels, TheyFollowTheWholeJointsForceAndMotion) {
  const JointData data = prepare(recorded(3.0), rig().actuator, rig().noise.position);
  const JointModel model(rig().actuator, rig().swing_load);
  const Observer observer;
  const Span all{0, data.size()};
  const auto force = model.simulate(data, all, Model::nominal(), Channel::kForce, observer);
  const auto motion = model.simulate(data, all, Model::nominal(), Channel::kMotion, observer);
  // Two substeps per period and a smoothed motion against an integrator of 1e-6.
  EXPECT_LT(relative_error(data.force, force, 300), 0.05);
  EXPECT_LT(relative_error(data.motion, motion, 300), 0.001);
}

// The first half leaves the spool a width above a current that then stays within the hysteresis.
TEST(SideModels, TheSpoolOfASecondHalfStandsWhereTheFirstHalfHasPutIt) {
  constexpr std::size_t kHalf = 1000;
  const double width_A = 0.05 * rig().actuator.valve_current_max_A;
  const Recording recording = recorded_rig(2 * kHalf, rig().swing_load, [&](int k) {
    return k < 900 ? 2.0 * width_A * std::sin(0.02 * k) : 0.2 * width_A * std::sin(0.05 * k);
  });
  const JointData data = prepare(recording, rig().actuator, rig().noise.position);
  const JointModel model(rig().actuator, rig().swing_load);
  Model sticks = Model::nominal();
  sticks.effects = {{plant::find_effect("valve_hysteresis"), {0.05}}};
  const Observer observer;
  const auto whole = model.simulate(data, {0, data.size()}, sticks, Channel::kForce, observer);
  const auto half = model.simulate(data, {kHalf, data.size()}, sticks, Channel::kForce, observer);
  const auto without = model.simulate(data, {kHalf, data.size()}, Model::nominal(), Channel::kForce, observer);
  EXPECT_GT(std::abs(whole.back() - without.back()), 10.0 * rig().noise.force);
  EXPECT_NEAR(half.back(), whole.back(), 0.01 * std::abs(whole.back() - without.back()));
}

TEST(SideModels, TheMassOfALoadThatRingsWithTheOilIsFoundWithoutBias) {
  for (const double factor : {1.0, 1.4}) {
    const JointData data = prepare(recorded(4.0, factor), rig().actuator, rig().noise.position);
    const JointModel model(rig().actuator, rig().swing_load);
    const JointSimulator simulator(model, data);
    FitData fitted{&simulator, {false, true, false}, {1.0, 1e-3, 1.0}};
    Model start = Model::nominal();
    start.effects = {{plant::find_effect("load_mass"), {1.1}}};
    const FitResult result = fit(fitted, {0, data.size()}, start, {false, true, false}, {});
    EXPECT_NEAR(result.model.effects[0].fitted[0], factor, 0.02 * factor);
  }
}

// A current or spool that changes between samples bends the force between them; that bend is no mass of the load.
TEST(SideModels, ALoadsMassIsFoundWithoutBiasBehindALateOrSlowValve) {
  const plant::Scales scales(rig().actuator, rig().swing_load);
  const JointModel model(rig().actuator, rig().swing_load);
  for (const auto& [name, fitted] :
       {std::pair{"input_delay", std::vector{0.8e-3}}, std::pair{"valve_dynamics", std::vector{0.6e-3, 0.7}}}) {
    const plant::EffectId valve = plant::find_effect(name);
    const NoiseStream draw(7, "diagnosis_fit_test", "current");
    const Recording recording = recorded_rig(3000, rig().swing_load, [&](int k) { return draw.normal(k) * 1e-3; },
                                             {plant::active_effect(valve, fitted, scales)});
    const JointData data = prepare(recording, rig().actuator, rig().noise.position);
    const JointSimulator simulator(model, data);
    const FitData judged{&simulator, {false, true, false}, {1.0, 1e-3, 1.0}};
    Model start = Model::nominal();
    start.effects = {{valve, fitted}, {plant::find_effect("load_mass"), {1.05}}};
    const FitResult result = fit(judged, {0, data.size()}, start, {false, true, false}, {});
    EXPECT_NEAR(result.model.effects[1].fitted[0], 1.0, 0.005) << name;
  }
}

/// The rig with a part of its load's mass on a spring, under random steps of the current.
Recording recorded_flexible(const plant::FlexibleParams& part) {
  plant::LoadParams load = rig().swing_load;
  load.flexible = part;
  const NoiseStream draw(7, "diagnosis_fit_test", "current");
  return recorded_rig(2000, load, [&](int k) { return (2.0 * draw.uniform(k / 60) - 1.0) * 1e-3; });
}

TEST(SideModels, APartOfTheLoadOnASpringIsFoundFromTheNearestOfItsStarts) {
  const plant::FlexibleParams part{0.3, 62.0, 0.04};
  const JointData data = prepare(recorded_flexible(part), rig().actuator, rig().noise.position);
  const JointModel model(rig().actuator, rig().swing_load);
  const JointSimulator simulator(model, data);
  const FitData fitted{&simulator, {false, true, false}, {1.0, 1e-3, 1.0}};
  const std::vector<std::vector<double>> starts = simulator.starts(plant::find_effect("flexible_load"));
  const auto nearest = std::ranges::min_element(
      starts, {}, [&](const auto& start) { return std::abs(start[1] - part.natural_frequency_rad_s); });
  Model from = Model::nominal();
  from.effects = {{plant::find_effect("flexible_load"), *nearest}};
  const FitResult result = fit(fitted, {0, data.size()}, from, {false, true, false}, {});
  const std::vector<double>& found = result.model.effects[0].fitted;
  EXPECT_NEAR(found[0], part.share, 0.02 * part.share);
  EXPECT_NEAR(found[1], part.natural_frequency_rad_s, 0.02 * part.natural_frequency_rad_s);
  EXPECT_NEAR(found[2], part.damping, 0.1 * part.damping);
}

TEST(SideModels, APartOnASpringSwingsInASecondHalfAsTheFirstHalfHasLeftIt) {
  const JointData data = prepare(recorded_flexible({0.3, 30.0, 0.01}), rig().actuator, rig().noise.position);
  const JointModel model(rig().actuator, rig().swing_load);
  Model swings = Model::nominal();
  swings.effects = {{plant::find_effect("flexible_load"), {0.3, 30.0, 0.01}}};
  const std::size_t begin = data.size() / 2;
  const Observer observer;
  const auto whole = model.simulate(data, {0, data.size()}, swings, Channel::kMotion, observer);
  const auto half = model.simulate(data, {begin, data.size()}, swings, Channel::kMotion, observer);
  const auto without = model.simulate(data, {begin, data.size()}, Model::nominal(), Channel::kMotion, observer);
  double error = 0.0;
  double change = 0.0;
  for (std::size_t i = 300; i < 600; ++i) {
    error += std::abs(half[i] - whole[begin + i]);
    change += std::abs(without[i] - whole[begin + i]);
  }
  EXPECT_LT(error, 0.05 * change);
}

TEST(SideModels, DerivativesAreThoseOfFiniteDifferences) {
  const JointData data = prepare(recorded(1.0), rig().actuator, rig().noise.position);
  const JointModel model(rig().actuator, rig().swing_load);
  for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
    const plant::EffectInfo& info = plant::effect_info(id);
    if (std::string_view(info.name) == "end_stop") {
      continue;  // does not touch what stays in mid-stroke
    }
    const Channel channel = info.side == plant::Side::kLoad             ? Channel::kMotion
                            : info.side == plant::Side::kVelocitySensor ? Channel::kVelocitySensor
                                                                        : Channel::kForce;
    Model middle = Model::nominal();
    middle.effects = {{id, {}}};
    for (const plant::Parameter& parameter : info.parameters) {
      middle.effects[0].fitted.push_back(parameter.starts[0]);
    }
    expect_slopes(model, data, middle, 0, channel);
  }
}

TEST(MotionSmoother, IsLinear) {
  const MotionSmoother smoother(0.001, 1e3, 2e-6);
  std::vector<double> one, other, sum;
  for (int i = 0; i < 500; ++i) {
    one.push_back(0.01 * std::sin(0.05 * i));
    other.push_back(1e-4 * std::cos(0.3 * i));
    sum.push_back(one.back() + other.back());
  }
  const auto a = smoother.smooth<double>(one, {0.0, 0.0, 0.0});
  const auto b = smoother.smooth<double>(other, {0.0, 0.0, 0.0});
  const auto c = smoother.smooth<double>(sum, {0.0, 0.0, 0.0});
  for (std::size_t i = 0; i < sum.size(); ++i) {
    EXPECT_NEAR(c[i][1], a[i][1] + b[i][1], 1e-9);
  }
}

TEST(SideModels, AFastWaySmoothlyMadeLooksLikeNoForceOnTheLoad) {
  // Between samples the oil is compressed over the way, not by stiffness times position: at 0.3 m/s that is 1 N.
  auto joint = plant::HydraulicJoint::create(rig().actuator, rig().swing_load,
                                             plant::equilibrium(rig().actuator, rig().swing_load, 0.02, 0.0))
                   .value();
  Recording recording;
  recording.period_s = 0.001;
  for (int k = 0; k < 2000; ++k) {
    const double current = 8e-3 * std::sin(25.0 * k * 1e-3);
    recording.valve_current_A.push_back(current);
    recording.position.push_back(joint.state().position);
    recording.velocity.push_back(joint.state().velocity);
    recording.force.push_back(joint.load_cell_force());
    joint.step(current, 0.0, recording.period_s);
  }
  ASSERT_GT(*std::ranges::max_element(recording.velocity), 0.2);
  const JointData data = prepare(recording, rig().actuator, rig().noise.position);
  const JointModel model(rig().actuator, rig().swing_load);
  const JointSimulator simulator(model, data);
  const auto error = residuals(simulator, {0, data.size()}, Model::nominal(), Channel::kMotion, {});
  const double force =
      rig().swing_load.damping * std::accumulate(error.begin(), error.end(), 0.0) / static_cast<double>(error.size());
  EXPECT_LT(std::abs(force), 0.1);
  EXPECT_LT(rig().swing_load.damping * judged_rms(error), 0.3);
}

TEST(JointData, TheLoadIsJudgedFromWhereItsSwingHasSettled) {
  Recording recording = recorded(1.0);
  recording.swing.assign(recording.position.size(), 1);
  std::fill(recording.swing.begin() + 400, recording.swing.begin() + 500, std::uint8_t{0});
  const JointData data = prepare(recording, rig().actuator, rig().noise.position);
  EXPECT_EQ(data.swing[0], 1);
  EXPECT_EQ(data.swing[399], 1);
  EXPECT_EQ(data.swing[400], 0);
  EXPECT_EQ(data.swing[519], 0);
  EXPECT_EQ(data.swing[520], 1);
}

TEST(Fit, KeepsNominalConstantsWithinTheirBandAndFindsTheHiddenCurrentOffset) {
  Recording recording = recorded(4.0);
  constexpr double kBias_A = 1.5e-4;
  for (double& current : recording.valve_current_A) {
    current -= kBias_A;  // the valve had more than the command says
  }
  const JointData data = prepare(recording, rig().actuator, rig().noise.position);
  const JointModel model(rig().actuator, rig().swing_load);
  const JointSimulator simulator(model, data);
  const FitData fitted{&simulator, {true, false, false}, {10.0, 1.0, 1.0}};
  Model start = Model::nominal();
  start.effects = {{plant::find_effect("valve_bias"), {0.002}}};
  const FitResult result = fit(fitted, {0, data.size()}, start, {true, false, false}, {});
  const auto& bias = plant::effect_info(start.effects[0].id).parameters[0];
  EXPECT_NEAR(model.scales().value(bias, result.model.effects[0].fitted[0]), kBias_A, 0.02 * kBias_A);
  for (const double factor : result.model.factors) {
    EXPECT_LE(std::abs(factor - 1.0), kNominalBand + 1e-12);
  }
}

// A gain of the load cell goes with the areas, which the recording does not tell from it.
TEST(Fit, TheDeviationOfANumberHasTheUncertaintyOfThePriorsThatItGoesWith) {
  const JointData data = prepare(recorded(4.0), rig().actuator, rig().noise.position);
  const JointModel model(rig().actuator, rig().swing_load);
  const JointSimulator simulator(model, data);
  const FitData fitted{&simulator, {true, true, false}, {1.0, 1e-3, 1.0}};
  Model start = Model::nominal();
  start.effects = {{plant::find_effect("force_sensor_gain"), {1.0}}};
  const auto deviation = [&](double spread) {
    return fit(fitted, {0, data.size()}, start, {true, true, false}, {.nominal_spread = spread}).deviation.front();
  };
  // Mass and damping of the load, areas and damping of the piston have the scale of the force, too.
  constexpr double kSpread = 0.01;
  EXPECT_GT(deviation(kSpread), 0.2 * kSpread);
  EXPECT_LT(deviation(kSpread), 1.5 * kSpread);
  EXPECT_LT(deviation(1e-6), 0.5 * deviation(kSpread));
}

TEST(Fit, AStartThatMakesNoFiniteSimulationIsAnAnswerAndNoCrash) {
  const JointData data = prepare(recorded(1.0), rig().actuator, rig().noise.position);
  const JointModel model(rig().actuator, rig().swing_load);
  const JointSimulator simulator(model, data);
  const FitData fitted{&simulator, {true, false, false}, {1.0, 1.0, 1.0}};
  Model start = Model::nominal();
  start.factors.fill(std::nan(""));
  start.effects = {{plant::find_effect("valve_bias"), {std::nan("")}}};
  const FitResult result = fit(fitted, {0, data.size()}, start, {true, false, false}, {});
  EXPECT_FALSE(std::isfinite(result.cost));
}

}  // namespace fit_test
}  // namespace farrier::diagnosis
