#include "world/scene_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace farrier::world {
namespace scene_file_test {

body::Scene scene_of(const std::string& text) {
  auto scene = load_scene_text(text, "scene.yaml");
  EXPECT_TRUE(scene.ok()) << (scene ? "" : to_string(scene.error()));
  return scene ? scene.value() : body::Scene{};
}

std::string problem_of(const std::string& text) {
  const auto scene = load_scene_text(text, "scene.yaml");
  return scene ? "" : to_string(scene.error());
}

TEST(SceneFile, LoadsEveryShippedScene) {
  for (const char* name : {"blocks", "disturbed", "supply"}) {
    const auto scene = load_scene(FARRIER_SCENES + std::string(name) + ".yaml");
    EXPECT_TRUE(scene.ok()) << (scene ? "" : to_string(scene.error()));
  }
}

TEST(SceneFile, BuildsStairsThatRise) {
  const body::Scene scene = scene_of("stairs: {up: {x_m: 1, rise_m: 0.1, run_m: 0.3, steps: 3}}");
  ASSERT_EQ(scene.boxes.size(), 3u);
  for (std::size_t step = 0; step < 3; ++step) {
    const body::Box& box = scene.boxes[step];
    EXPECT_NEAR(box.centre_m.x() - box.half_extents_m.x(), 1.0 + 0.3 * static_cast<double>(step), 1e-12);
    EXPECT_NEAR(box.centre_m.z() + box.half_extents_m.z(), 0.1 * static_cast<double>(step + 1), 1e-12);
    EXPECT_NEAR(box.centre_m.z() - box.half_extents_m.z(), 0.0, 1e-12);
  }
}

TEST(SceneFile, DrawsBlocksFromTheirSeed) {
  const auto field = [](int seed) {
    return scene_of("blocks: {f: {x_m: 1, y_m: -1, length_m: 3, width_m: 2, size_m: 0.5, height_m: 0.1, seed: " +
                    std::to_string(seed) + "}}");
  };
  const body::Scene scene = field(1);
  EXPECT_GT(scene.boxes.size(), 20u);
  EXPECT_LE(scene.boxes.size(), 24u);
  double lowest_m = 1.0, highest_m = 0.0;
  for (const body::Box& box : scene.boxes) {
    lowest_m = std::min(lowest_m, 2.0 * box.half_extents_m.z());
    highest_m = std::max(highest_m, 2.0 * box.half_extents_m.z());
    EXPECT_GE(box.centre_m.x() - box.half_extents_m.x(), 1.0 - 1e-12);
    EXPECT_LE(box.centre_m.x() + box.half_extents_m.x(), 4.0 + 1e-12);
    EXPECT_LE(std::abs(box.centre_m.y()) + box.half_extents_m.y(), 1.0 + 1e-12);
  }
  EXPECT_LT(lowest_m, 0.03);
  EXPECT_GT(highest_m, 0.07);
  EXPECT_LE(highest_m, 0.1);
  EXPECT_EQ(field(1).boxes[5].half_extents_m, scene.boxes[5].half_extents_m);
  EXPECT_NE(field(2).boxes[5].half_extents_m, scene.boxes[5].half_extents_m);
}

TEST(SceneFile, TurnsTheGroundDownhillForAPositivePitch) {
  const body::Scene scene = scene_of("ground: {pitch_rad: 0.1}");
  EXPECT_LT((scene.ground * Eigen::Vector3d::UnitX()).z(), -0.09);
}

TEST(SceneFile, RefusesAPushOnABodyThatIsNotThere) {
  EXPECT_EQ(problem_of("pushes:\n  side: {body: tail, start_s: 1, impulse_y_Ns: 80}"),
            "scene.yaml:2: pushes.side.body: tail is no body that it can act on: give trunk\n");
}

TEST(SceneFile, ReadsFaultsOfTheSupply) {
  const body::Scene scene =
      scene_of("supply:\n  cut: {start_s: 9, pump_flow_m3_s: 0}\n  lost: {start_s: 8, accumulator_volume_m3: 1e-4}");
  ASSERT_EQ(scene.supply_changes.size(), 2u);
  EXPECT_EQ(scene.supply_changes[0].name, "cut");
  EXPECT_EQ(scene.supply_changes[0].start_s, 9.0);
  EXPECT_EQ(scene.supply_changes[0].pump_flow_m3_s, 0.0);
  EXPECT_FALSE(scene.supply_changes[0].accumulator_volume_m3);
  EXPECT_EQ(scene.supply_changes[0].origin, "scene.yaml:2");
  EXPECT_FALSE(scene.supply_changes[1].pump_flow_m3_s);
  EXPECT_EQ(scene.supply_changes[1].accumulator_volume_m3, 1e-4);
}

TEST(SceneFile, RefusesAFaultOfTheSupplyWithoutValuesOrOutOfRange) {
  EXPECT_EQ(
      problem_of("supply:\n  cut: {start_s: 9}"),
      "scene.yaml:2: supply.cut.pump_flow_m3_s: is missing, and so is accumulator_volume_m3: give at least one of "
      "them\n");
  EXPECT_EQ(problem_of("supply:\n  cut: {start_s: 9, pump_flow_m3_s: -1}"),
            "scene.yaml:2: supply.cut.pump_flow_m3_s: -1 is out of range: give 0 to 1\n");
  EXPECT_EQ(problem_of("supply:\n  cut: {start_s: -1, pump_flow_m3_s: 0}"),
            "scene.yaml:2: supply.cut.start_s: -1 is out of range: give 0 to 1e+05\n");
}

TEST(SceneFile, ReadsChangesOfActuators) {
  const body::Scene scene = scene_of(
      "actuators:\n  coil: {joint: lf_kfe, start_s: 12, valve_gain_factor: 0.5}\n"
      "  oil: {start_s: 1, duration_s: 30, viscosity_factor: 0.4, bulk_modulus_factor: 0.9}\n"
      "  stuck: {joint: rh_hfe, stuck_A: 0}");
  ASSERT_EQ(scene.actuator_changes.size(), 3u);
  EXPECT_EQ(scene.actuator_changes[0].joint, "lf_kfe");
  EXPECT_EQ(scene.actuator_changes[0].start_s, 12.0);
  EXPECT_EQ(scene.actuator_changes[0].duration_s, 0.0);
  EXPECT_EQ(scene.actuator_changes[0].valve_gain, 0.5);
  EXPECT_FALSE(scene.actuator_changes[0].viscosity);
  EXPECT_EQ(scene.actuator_changes[0].origin, "scene.yaml:2");
  EXPECT_EQ(scene.actuator_changes[1].joint, "") << "all joints";
  EXPECT_EQ(scene.actuator_changes[1].duration_s, 30.0);
  EXPECT_EQ(scene.actuator_changes[2].stuck_A, 0.0);
}

TEST(SceneFile, RefusesAnActuatorWithoutValveGain) {
  EXPECT_EQ(problem_of("actuators:\n  coil: {valve_gain_factor: 0}"),
            "scene.yaml:2: actuators.coil.valve_gain_factor: 0 is out of range: give 0.01 to 10\n");
}

TEST(SceneFile, TellsEveryBoxItsLine) {
  const body::Scene scene = scene_of(
      "boxes:\n  table: {x_m: 1, length_m: 1, width_m: 1, height_m: 1}\n"
      "stairs:\n  up: {x_m: 1, rise_m: 0.1, run_m: 0.3, steps: 1}");
  EXPECT_EQ(scene.boxes.at(0).origin, "scene.yaml:2");
  EXPECT_EQ(scene.boxes.at(1).origin, "scene.yaml:4");
}

TEST(SceneFile, RefusesABoxWithoutHeight) {
  EXPECT_EQ(problem_of("boxes:\n  table: {x_m: 1, length_m: 1, width_m: 1, height_m: 0}"),
            "scene.yaml:2: boxes.table.height_m: 0 is out of range: give 0.001 to 1000\n");
}

TEST(SceneFile, RefusesMoreBlocksThanItCanSimulate) {
  EXPECT_EQ(problem_of("blocks: {f: {x_m: 1, y_m: -1, length_m: 30, width_m: 20, size_m: 0.1, height_m: 0.1}}"),
            "scene.yaml:1: blocks.f.size_m: makes more than 2000 blocks: give larger ones or a smaller field\n");
  EXPECT_EQ(problem_of("blocks:\n  f: {x_m: 1, y_m: -1, length_m: 30, width_m: 20, size_m: 0.6, height_m: 0.1}\n"
                       "  g: {x_m: 1, y_m: -1, length_m: 30, width_m: 20, size_m: 0.6, height_m: 0.1}"),
            "scene.yaml:1: has 3272 boxes and blocks: give at most 2000\n");
}

TEST(SceneFile, RefusesAnUnknownKey) {
  EXPECT_EQ(problem_of("frictoin: 1"), "scene.yaml:1: frictoin: is not a known parameter: did you mean friction?\n");
}

}  // namespace scene_file_test
}  // namespace farrier::world
