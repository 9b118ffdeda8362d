#include "trace/body_trace.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/scratch_directory.hpp"

namespace farrier::trace {
namespace body_trace_test {

signals::BodyTruth truth_of(Tick tick) {
  signals::BodyTruth truth;
  truth.tick = tick;
  truth.position_m = {0.1, -1.0 / 3.0, 1e-300};
  truth.attitude = {1.0, 0.0, -0.25, 2e-17};
  truth.velocity_m_s = {0.4, 0.0, -0.02};
  truth.angular_velocity_rad_s = {1.0, 2.0, 3.0};
  truth.push_N = {0.0, 800.0, 0.0};
  for (std::size_t i = 0; i < 12; ++i) {
    truth.foot_force_N[i] = 100.0 / static_cast<double>(i + 3);
  }
  return truth;
}

TEST(BodyTrace, ReadsBackEveryNumberExactly) {
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("trace_body.csv");
  auto writer = BodyTraceWriter::create(path, 4).value();
  writer.write(truth_of(0));
  writer.write(truth_of(1));
  ASSERT_TRUE(writer.finish());
  const auto rows = read_body_trace(path, 4);
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows.value().size(), 2u);
  EXPECT_EQ(rows.value()[1].tick, 1);
  EXPECT_EQ(rows.value()[1].position_m, truth_of(1).position_m);
  EXPECT_EQ(rows.value()[1].attitude, truth_of(1).attitude);
  EXPECT_EQ(rows.value()[1].push_N, truth_of(1).push_N);
  EXPECT_EQ(rows.value()[1].foot_force_N, truth_of(1).foot_force_N);
}

TEST(BodyTrace, RefusesAnotherFileWithTheLine) {
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("trace_body.csv");
  auto writer = BodyTraceWriter::create(path, 4).value();
  writer.write(truth_of(0));
  ASSERT_TRUE(writer.finish());
  EXPECT_NE(read_body_trace(path, 6).error().message.find(":1: not the trace of a body with 6 legs"),
            std::string::npos);
  std::ofstream(path, std::ios::app) << "1,2,3\n";
  EXPECT_NE(read_body_trace(path, 4).error().message.find(":3: not a line"), std::string::npos);
}

TEST(BodyTrace, LiesBesideTheTraceOfTheJoints) {
  EXPECT_EQ(body_trace_path("out/trot/trace.csv"), "out/trot/trace_body.csv");
}

}  // namespace body_trace_test
}  // namespace farrier::trace
