// Every study of the thesis, as a user runs them.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "farrier_command.hpp"

namespace farrier::test {
namespace reproduce_test {

TEST(ReproduceAll, GivesEveryClaimItsPinnedVerdictOverSevenSeeds) {
  const ScratchDirectory scratch;
  FarrierCommand command({"reproduce", "all", "--out", scratch.file("out"), "--json"});
  const int status = command.wait(std::chrono::seconds(600));
  const std::string output = command.output();
  ASSERT_NE(output.find('{'), std::string::npos) << output;
  // Progress stands before it, for both outputs are in one file.
  const auto run = nlohmann::json::parse(output.substr(output.find('{')), nullptr, false);
  ASSERT_FALSE(run.is_discarded()) << output;
  std::set<std::string> verdicts, studies;
  std::size_t most_seeds = 0;
  for (const auto& claim : run["claims"]) {
    verdicts.insert(claim["verdict"]);
    studies.insert(claim["figure"]);
    // A claim whose value does not exist, such as the frequency of a peak that is not there, fails.
    EXPECT_TRUE(claim["measured"]["value"].is_number() || claim["verdict"] == "fails") << claim;
    most_seeds = std::max(most_seeds, claim["measured"]["by_seed"].size());
  }
  EXPECT_EQ(most_seeds, 7u);
  EXPECT_TRUE(verdicts.contains("holds") && verdicts.contains("needs") && verdicts.contains("refuted"));
  EXPECT_FALSE(run.contains("failures")) << run["failures"];
  EXPECT_EQ(run["verdict"], "pass");
  EXPECT_EQ(status, 0);
  std::string list;
  ASSERT_EQ(run_farrier({"reproduce", "--list"}, &list), 0);
  for (const std::string& study : studies) {
    EXPECT_NE(list.find(study + "  "), std::string::npos) << study;
  }
  EXPECT_GE(studies.size(), 50u);
  EXPECT_EQ(read_json(scratch.file("out/figures.json"))["claims"], run["claims"]);
  EXPECT_TRUE(std::filesystem::exists(scratch.file("out/index.html")));
}

}  // namespace reproduce_test
}  // namespace farrier::test
