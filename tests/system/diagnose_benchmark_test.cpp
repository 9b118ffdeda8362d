// Every blind trial: an effect is hidden by code that the diagnosis does not share, and is found. Writes what was taken
// for what into the documentation.

#include <gtest/gtest.h>

#include "farrier_command.hpp"

namespace farrier::test {
namespace diagnose_benchmark_test {

TEST(DiagnoseBenchmark, EveryBoundHoldsOverAllTrials) {
  const ScratchDirectory scratch;
  FarrierCommand benchmark({"diagnose", "--benchmark", "--json", scratch.file("figures.json"), "--confusion",
                            FARRIER_DOCS "/diagnosis-confusion.md"});
  const int status = benchmark.wait(std::chrono::hours(1));
  EXPECT_EQ(status, 0) << benchmark.output();
  const auto json = read_json(scratch.file("figures.json"));
  double trials = 0.0;
  for (const auto& figure : json["figures"]) {
    trials = figure["name"] == "diagnose.benchmark.trials" ? figure["value"].get<double>() : trials;
  }
  EXPECT_GE(trials, 300.0);
}

}  // namespace diagnose_benchmark_test
}  // namespace farrier::test
