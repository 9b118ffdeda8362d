// Growth of processes is judged by the one that grows most, which is named.

#include <gtest/gtest.h>

#include "report/figures/run_info.hpp"

namespace farrier::report {
namespace growth_test {

ProcessInfo process(const char* name, std::optional<Growth> growth) {
  ProcessInfo info;
  info.name = name;
  info.growth = growth;
  return info;
}

TEST(Growth, IsThatOfTheProcessThatGrowsMost) {
  Figures figures;
  const auto failures = add_growth(figures, {process("supervisor", Growth{-8, 0, 0}), process("launcher", std::nullopt),
                                             process("sim_bridge", Growth{kMemoryGrowth_KiB, 0, 0})});
  EXPECT_EQ(figures.find("trot.memory_growth_KiB")->value, kMemoryGrowth_KiB);
  EXPECT_TRUE(figures.find("trot.threads_growth")->holds());
  EXPECT_EQ(failures, std::vector<std::string>{});
}

TEST(Growth, BeyondItsBoundFailsByTheProcesssName) {
  Figures figures;
  const auto failures = add_growth(figures, {process("sim_bridge", Growth{0, 0, 2}), process("joint_node", Growth{0, 1, 0})});
  EXPECT_FALSE(figures.find("trot.threads_growth")->holds());
  EXPECT_EQ(failures, (std::vector<std::string>{"joint_node grew by 1 threads after the first tenth of the run",
                                                "sim_bridge grew by 2 descriptors after the first tenth of the run"}));
}

TEST(Growth, OfNobodyHoldsNoBound) {
  Figures figures;
  EXPECT_TRUE(add_growth(figures, {process("sim_bridge", std::nullopt)}).empty());
  EXPECT_FALSE(figures.find("trot.memory_growth_KiB")->holds());
}

}  // namespace growth_test
}  // namespace farrier::report
