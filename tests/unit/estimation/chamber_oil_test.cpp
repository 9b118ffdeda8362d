// The oil that a cylinder's chambers need before the flow law holds, and a force loop that oscillates.

#include "estimation/valve/chamber_oil.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "estimation/valve/oscillation_monitor.hpp"
#include "robot/robot.hpp"

namespace farrier::estimation {
namespace chamber_oil_test {

constexpr double kMillilitre_m3 = 1e-6;

plant::ActuatorParams hfe() {
  return robot::load_robot(FARRIER_ROBOTS "hyq.yaml", {.on_ground = true}).value().find("lf_hfe")->actuator;
}

plant::OperatingPoint at_force(const plant::ActuatorParams& actuator, double force_N, double valve_sign) {
  return {.position = 0.5 * actuator.stroke, .load_pressure_Pa = force_N / actuator.area_a, .valve_sign = valve_sign};
}

TEST(ChamberOil, IsSteadyOnceTheChambersHaveTakenTheOilOfTheChangeOfSide) {
  const plant::ActuatorParams actuator = hfe();
  ChamberOil oil(actuator);
  const plant::OperatingPoint idle = at_force(actuator, 0.0, 1.0);
  EXPECT_FALSE(oil.take(actuator, idle, 0.01 * kMillilitre_m3));
  EXPECT_TRUE(oil.fills());
  EXPECT_TRUE(oil.take(actuator, idle, kMillilitre_m3));
  oil.interrupt();
  EXPECT_FALSE(oil.fills());
  EXPECT_FALSE(oil.take(actuator, idle, 0.01 * kMillilitre_m3));
}

// With an open port to a, alpha^3 p_s is the most that chamber b can push back: the pressure of a would be below zero.
TEST(ChamberOil, WaitsUntilAVoidIsFilledThatAPullingLoadHasMade) {
  const plant::ActuatorParams actuator = hfe();
  const double alpha = actuator.area_b / actuator.area_a;
  const double limit_N = -alpha * alpha * alpha * actuator.supply_pressure_Pa * actuator.area_a;
  ChamberOil oil(actuator);
  EXPECT_TRUE(oil.take(actuator, at_force(actuator, 0.9 * limit_N, 1.0), kMillilitre_m3)) << "no void yet";
  EXPECT_FALSE(oil.take(actuator, at_force(actuator, 1.1 * limit_N, 1.0), kMillilitre_m3));
  const plant::OperatingPoint back = at_force(actuator, 0.5 * limit_N, -1.0);
  EXPECT_FALSE(oil.take(actuator, back, 0.6 * kMillilitre_m3)) << "fills the void";
  EXPECT_FALSE(oil.fills());
  EXPECT_FALSE(oil.take(actuator, back, 0.6 * kMillilitre_m3)) << "the rest of the void";
  EXPECT_TRUE(oil.take(actuator, back, kMillilitre_m3));
}

bool finds_sine(double frequency_Hz, double amplitude, int ticks) {
  OscillationMonitor monitor;
  bool found = false;
  for (int tick = 0; tick < ticks; ++tick) {
    found = found || monitor.take(amplitude * std::sin(2.0 * 3.141592653589793 * frequency_Hz * 1e-3 * tick));
  }
  return found;
}

TEST(OscillationMonitor, FindsALargeErrorAroundTheCrossoverWithinFiftyMilliseconds) {
  for (const double frequency_Hz : {80.0, 115.0, 150.0}) {
    EXPECT_TRUE(finds_sine(frequency_Hz, 0.25, 50)) << frequency_Hz;
  }
}

TEST(OscillationMonitor, LeavesASmallErrorASlowOneAndAFastOneAlone) {
  EXPECT_FALSE(finds_sine(115.0, 0.1, 2000)) << "a mean of 0.064";
  EXPECT_FALSE(finds_sine(40.0, 0.5, 2000)) << "a body that sways";
  EXPECT_FALSE(finds_sine(240.0, 0.5, 2000)) << "an impact that rings in the oil";
}

TEST(OscillationMonitor, LeavesATransientAloneThatDecays) {
  OscillationMonitor monitor;
  for (int tick = 0; tick < 200; ++tick) {
    const double error = 0.8 * std::exp(-tick / 12.0) * std::cos(2.0 * 3.141592653589793 * 0.115 * tick);
    EXPECT_FALSE(monitor.take(error)) << tick;
  }
}

}  // namespace chamber_oil_test
}  // namespace farrier::estimation
