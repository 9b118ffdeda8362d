// The supply that all actuators of a robot share.

#include "plant/supply.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace farrier::plant {
namespace supply_test {

constexpr double kStep_s = 2.5e-4;
constexpr double kLitrePerMinute_m3_s = 1e-3 / 60.0;

SupplyParams hyq_supply() {
  return {.relief_pressure_Pa = 160e5,
          .return_pressure_Pa = 0.0,
          .pump_flow_m3_s = 12.0 * kLitrePerMinute_m3_s,
          .accumulator_volume_m3 = 5e-4,
          .precharge_Pa = 100e5,
          .polytropic_exponent = 1.3,
          .compliance_m3_Pa = 1.4e-12,
          .null_leakage_m3_s_Pa = 12.0 * 2.6e-13};
}

void draw(Supply& supply, double flow_m3_s, double time_s) {
  for (int i = 0; i < static_cast<int>(std::lround(time_s / kStep_s)); ++i) {
    supply.advance(flow_m3_s * kStep_s, kStep_s);
  }
}

double found_J(const Supply& supply, double stored_before_J) {
  const SupplyAccount& a = supply.account();
  return a.actuators_J + a.relief_J + a.leakage_J + supply.stored_J() - stored_before_J;
}

TEST(Supply, StaysAtTheReliefPressureWhileThePumpGivesMore) {
  Supply supply = Supply::create(hyq_supply()).value();
  EXPECT_EQ(supply.pressure_Pa(), 160e5);
  draw(supply, 5.0 * kLitrePerMinute_m3_s, 1.0);
  EXPECT_EQ(supply.pressure_Pa(), 160e5);
  EXPECT_GT(supply.account().relief_m3, 0.0);
  EXPECT_NEAR(found_J(supply, Supply::create(hyq_supply()).value().stored_J()), supply.account().pump_J,
              1e-3 * supply.account().pump_J);
}

TEST(Supply, FallsAsTheGasExpands) {
  SupplyParams params = hyq_supply();
  params.pump_flow_m3_s = 0.0;
  params.null_leakage_m3_s_Pa = 0.0;
  params.compliance_m3_Pa = 1e-16;  // the accumulator alone
  Supply supply = Supply::create(params).value();
  const double gas_m3 = 5e-4 * std::pow(100.0 / 160.0, 1.0 / 1.3);
  draw(supply, 1e-4, 0.5);
  EXPECT_NEAR(supply.pressure_Pa(), 160e5 * std::pow(gas_m3 / (gas_m3 + 5e-5), 1.3), 1e2);
}

TEST(Supply, AccountsForItsEnergyDownToThePrechargeAndBelow) {
  for (const double pump : {0.0, 6.0, 12.0}) {
    SupplyParams params = hyq_supply();
    params.pump_flow_m3_s = pump * kLitrePerMinute_m3_s;
    Supply supply = Supply::create(params).value();
    const double before_J = supply.stored_J();
    draw(supply, 20.0 * kLitrePerMinute_m3_s, 0.9);
    EXPECT_LT(supply.pressure_Pa(), 160e5);
    const double moved_J = supply.account().actuators_J + supply.account().leakage_J;
    EXPECT_NEAR(found_J(supply, before_J), supply.account().pump_J, 2e-3 * moved_J) << pump;
  }
}

TEST(Supply, RunsDryAtZeroAndFillsUpAgain) {
  SupplyParams params = hyq_supply();
  params.pump_flow_m3_s = 0.0;
  Supply supply = Supply::create(params).value();
  draw(supply, 20.0 * kLitrePerMinute_m3_s, 2.0);
  EXPECT_EQ(supply.pressure_Pa(), 0.0);
  supply.set_pump_flow(12.0 * kLitrePerMinute_m3_s);
  draw(supply, 0.0, 2.0);
  EXPECT_EQ(supply.pressure_Pa(), 160e5);
}

TEST(Supply, KeepsItsPressureWhenTheAccumulatorIsLost) {
  Supply supply = Supply::create(hyq_supply()).value();
  supply.set_pump_flow(0.0);
  draw(supply, 5.0 * kLitrePerMinute_m3_s, 0.2);
  const double before_Pa = supply.pressure_Pa();
  supply.set_accumulator_volume(1e-4);
  EXPECT_EQ(supply.pressure_Pa(), before_Pa);
  draw(supply, 5.0 * kLitrePerMinute_m3_s, 0.05);
  EXPECT_LT(supply.pressure_Pa(), before_Pa - 1e5);
}

TEST(Supply, RefusesWhatNoSupplyHasByName) {
  SupplyParams params = hyq_supply();
  params.pump_flow_m3_s = -1.0;
  params.precharge_Pa = 0.0;
  params.polytropic_exponent = 1.0;
  params.compliance_m3_Pa = 0.0;
  const auto refused = Supply::create(params);
  ASSERT_FALSE(refused.ok());
  for (const char* name : {"pump_flow_m3_s", "precharge_Pa", "polytropic_exponent", "compliance_m3_Pa"}) {
    EXPECT_NE(refused.error().message.find(name), std::string::npos) << refused.error().message;
  }
}

}  // namespace supply_test
}  // namespace farrier::plant
