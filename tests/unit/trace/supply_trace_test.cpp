#include "trace/supply_trace.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/scratch_directory.hpp"

namespace farrier::trace {
namespace supply_trace_test {

SupplyRow row_of(Tick tick) {
  SupplyRow row;
  row.state.tick = tick;
  row.state.pressure_Pa = 159.3e5;
  row.state.flow_m3_s = -1.0 / 3.0;
  row.state.pump_flow_m3_s = 2e-4;
  row.state.power_W = 3200.0;
  row.truth.pump_J = 1e4 / 3.0;
  row.truth.friction_J = 2e-17;
  row.truth.work_J = -12.5;
  return row;
}

TEST(SupplyTrace, ReadsBackEveryNumberExactly) {
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("trace_supply.csv");
  auto writer = SupplyTraceWriter::create(path).value();
  writer.write(row_of(0));
  writer.write(row_of(10));
  ASSERT_TRUE(writer.finish());
  const auto rows = read_supply_trace(path);
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows.value().size(), 2u);
  const SupplyRow& back = rows.value()[1];
  EXPECT_EQ(back.state.tick, 10);
  EXPECT_EQ(back.truth.tick, 10);
  EXPECT_EQ(back.state.pressure_Pa, row_of(10).state.pressure_Pa);
  EXPECT_EQ(back.state.flow_m3_s, row_of(10).state.flow_m3_s);
  EXPECT_EQ(back.state.power_W, row_of(10).state.power_W);
  EXPECT_EQ(back.truth.pump_J, row_of(10).truth.pump_J);
  EXPECT_EQ(back.truth.friction_J, row_of(10).truth.friction_J);
  EXPECT_EQ(back.truth.work_J, row_of(10).truth.work_J);
}

TEST(SupplyTrace, RefusesAnotherFileWithTheLine) {
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("trace_supply.csv");
  auto writer = SupplyTraceWriter::create(path).value();
  writer.write(row_of(0));
  ASSERT_TRUE(writer.finish());
  std::ofstream(path, std::ios::app) << "1,2,3\n";
  EXPECT_NE(read_supply_trace(path).error().message.find(":3: not a line of the trace of a supply"), std::string::npos);
  EXPECT_NE(read_supply_trace("/nowhere.csv").error().message.find(":1: not the trace of a supply"), std::string::npos);
}

TEST(SupplyTrace, LiesBesideTheTraceOfTheJoints) {
  EXPECT_EQ(supply_trace_path("out/trot/trace.csv"), "out/trot/trace_supply.csv");
}

}  // namespace supply_trace_test
}  // namespace farrier::trace
