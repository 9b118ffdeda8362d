// farrier bench while processes of its parts are killed.

#include <gtest/gtest.h>

#include <csignal>

#include "farrier_command.hpp"

namespace farrier::test {
namespace bench_parts_test {

TEST(Bench, KeepsWhatOtherPartsMeasureWhenAProcessIsKilled) {
  const ScratchDirectory scratch;
  const std::vector<std::string> options{"bench", "--ticks", "1000000", "--out", scratch.file("out"), "--only"};
  auto arguments = options;
  arguments.push_back("lockstep,riccati");
  FarrierCommand bench(arguments);
  for (const char* title : {"cyclone, bare exchange: tick", "fast, bare exchange: tick"}) {
    ASSERT_TRUE(bench.says(title)) << bench.output();
    const pid_t sim_bridge = bench.process("sim_bridge");
    ASSERT_NE(sim_bridge, 0) << bench.output();
    ASSERT_EQ(::kill(sim_bridge, SIGKILL), 0);
  }
  EXPECT_EQ(bench.wait(), 1) << bench.output();
  const nlohmann::json run = read_json(scratch.file("out/figures.json"));
  ASSERT_FALSE(run.is_discarded()) << bench.output();
  EXPECT_EQ(run["verdict"], "fail");
  ASSERT_EQ(run["failures"].size(), 2u) << run["failures"];
  for (const auto& failure : run["failures"]) {
    EXPECT_NE(failure.get<std::string>().find("ended with exit status 137"), std::string::npos) << failure;
  }
  EXPECT_EQ(run["failures"][0].get<std::string>().find("lockstep cyclone: "), 0u) << run["failures"];
  const double measured = figure(run, "bench.riccati.doubling_us");
  EXPECT_GT(measured, 0.0);

  arguments = options;
  arguments.insert(arguments.end(), {"riccati", "--continue"});
  std::string output;
  run_farrier(arguments, &output);  // its bounds are not what is tested
  EXPECT_NE(output.find("figures.json.parts: has riccati"), std::string::npos) << output;
  EXPECT_EQ(figure(read_json(scratch.file("out/figures.json")), "bench.riccati.doubling_us"), measured);
}

}  // namespace bench_parts_test
}  // namespace farrier::test
