// The search for an experiment that tells two models of a joint apart.

#include <gtest/gtest.h>

#include "diagnosis/judge/experiment.hpp"
#include "diagnosis/model/sides_of_joint.hpp"
#include "tests/unit/diagnosis/rig.hpp"

namespace farrier::diagnosis {
namespace telling_experiment_test {

constexpr SensorNoiseLevels kNoise{1e-5, 1e-3, 5.0};

Model with(const char* effect, std::vector<double> fitted) {
  Model model = Model::nominal();
  model.effects = {{plant::find_nameable(effect), std::move(fitted)}};
  return model;
}

TEST(HydraulicJointModel, RespondsAsTheWholeJointDoes) {
  const auto sides = sides_of(rig());
  std::vector<double> current_A;
  for (int k = 0; k < 200; ++k) {
    current_A.push_back(0.05 * rig().actuator.valve_current_max_A * (k / 20 % 2 == 0 ? 1.0 : -1.0));
  }
  const auto readings = sides->respond(Model::nominal(), current_A, 0.001);
  const double middle = 0.5 * rig().actuator.stroke;
  auto joint = plant::HydraulicJoint::create(rig().actuator, rig().swing_load,
                                             plant::equilibrium(rig().actuator, rig().swing_load, middle, 0.0))
                   .value();
  ASSERT_EQ(readings.size(), current_A.size());
  for (std::size_t k = 0; k < current_A.size(); ++k) {
    EXPECT_EQ(readings[k].position, joint.state().position) << k;
    EXPECT_EQ(readings[k].load_cell_force, joint.load_cell_force()) << k;
    joint.step(current_A[k], 0.0, 0.001);
  }
}

TEST(TellingExperiment, OfOneModelTwiceTellsNothing) {
  const auto sides = sides_of(rig());
  const Model model = with("load_mass", {1.1});
  const plant::EffectId id = model.effects[0].id;
  const Experiment best = telling_experiment(*sides, {id, id}, model, model, kNoise);
  EXPECT_EQ(best.difference, 0.0);
  EXPECT_FALSE(best.tells());
  EXPECT_EQ(best.amplitude_Nm, 0.0);
}

TEST(TellingExperiment, OfTwoMassesTellsThemApart) {
  const auto sides = sides_of(rig());
  const Model light = with("load_mass", {0.8});
  const plant::EffectId id = light.effects[0].id;
  EXPECT_TRUE(telling_experiment(*sides, {id, id}, light, with("load_mass", {1.2}), kNoise).tells());
}

}  // namespace telling_experiment_test
}  // namespace farrier::diagnosis
