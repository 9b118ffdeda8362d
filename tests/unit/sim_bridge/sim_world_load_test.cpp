#include "tests/unit/sim_bridge/sim_world_bench.hpp"

namespace farrier::sim_bridge {
namespace sim_world_load_test {

using namespace testing;

constexpr Tick kFirst = 20;
constexpr Tick kSecond = 50;

const robot::Robot& hyq() {
  static const robot::Robot robot = robot::load_shipped("hyq");
  return robot;
}

plant::LoadParams of_mass(double mass) { return {.mass = mass, .damping = 500.0}; }

void expect_mass(const SimWorld& world, std::size_t joint, double mass) {
  EXPECT_EQ(row_of(world, joint).load_mass_kg_or_kgm2, mass) << "joint " << joint << " at tick " << world.tick();
}

TEST(SimWorldLoads, ChangeExactlyAtTheirTickInWhateverOrderTheyAreGiven) {
  SimWorld world = SimWorld::create(hyq(), 1, {{kSecond, 2, of_mass(7.0)}, {kFirst, 2, of_mass(20.0)}}).value();
  const double stance = hyq().joints[2].stance_load.mass;
  while (world.tick() < kSecond + 10) {
    expect_mass(world, 2, world.tick() < kFirst ? stance : world.tick() < kSecond ? 20.0 : 7.0);
    expect_mass(world, 1, hyq().joints[1].stance_load.mass);
    world.advance(shut(world));
  }
}

TEST(SimWorldLoads, MayBeThereFromTheStart) {
  const SimWorld world = SimWorld::create(hyq(), 1, {{0, 4, of_mass(3.0)}}).value();
  expect_mass(world, 4, 3.0);
}

TEST(SimWorldLoads, ThatChangedStayWhateverThePhase) {
  SimWorld changed = SimWorld::create(hyq(), 1, {{0, 2, of_mass(20.0)}}).value();
  SimWorld usual = world_of(hyq());
  bool swung = false;
  for (int i = 0; i < 2500; ++i) {
    const auto row = row_of(changed, 2);
    ASSERT_EQ(row.load_mass_kg_or_kgm2, 20.0) << "at tick " << row.tick;
    ASSERT_EQ(row.actual_phase, row_of(usual, 2).actual_phase) << "the phase is told as it is";
    swung = swung || row.actual_phase == gait::Phase::kSwing;
    changed.advance(shut(changed));
    usual.advance(shut(usual));
  }
  EXPECT_TRUE(swung);
}

TEST(SimWorldLoads, AreRefusedWhenNoJointCanCarryThem) {
  const auto negative = SimWorld::create(hyq(), 1, {{0, 2, of_mass(-1.0)}});
  ASSERT_FALSE(negative);
  EXPECT_EQ(negative.error().message.find(hyq().joints[2].name), 0u) << negative.error().message;
  EXPECT_FALSE(SimWorld::create(hyq(), 1, {{0, 12, of_mass(1.0)}})) << "there is no such joint";
}

}  // namespace sim_world_load_test
}  // namespace farrier::sim_bridge
