#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <unistd.h>

#include "thesis/report/run_studies.hpp"
#include "thesis/report/study_page.hpp"
#include "thesis/report/study_pictures.hpp"

namespace farrier::thesis {
namespace reproduce_run_test {

using thesis::ClaimSpec;
using thesis::StudyContext;
using thesis::StudyResult;

constexpr ClaimSpec kClaims[] = {
    {"9.98.value", "9.9", "the <value> is small", "value", "1", thesis::Relation::kAtMost, 1.0}};

Result<StudyResult> quick(const StudyContext& context) {
  if (!thesis::keep_going(context, 0.5)) {
    return thesis::stopped();
  }
  thesis::Panel panel{.title = "quotes \" and \\",
                      .x_label = "x",
                      .y_label = "y",
                      .series = {{"line", {0.0, 1.0, 2.0}, {1.0, 0.0 / 0.0, 3.0}},
                                 {"", {0.0, 1.0}, {1.0, 2.0}, thesis::Style::kPoints, 0, {0.0, 1.0}},
                                 {"empty", {}, {}}}};
  return StudyResult{{{"9.98.value", 0.5, ""}},
                     {{"one", 2, {panel, {.title = "z", .x_label = "x", .y_label = "y", .unit_circle = true}}}}};
}

constexpr std::uint64_t kSeeds[] = {1, 2, 3};
constexpr std::span<const std::uint64_t> kOneSeed{kSeeds, 1};

/// A value by seed, and a picture.
Result<StudyResult> drawn(const StudyContext& context) {
  Picture picture{.caption = "one", .panels = {{.title = "z", .x_label = "x", .y_label = "y"}}};
  return StudyResult{{{"9.98.value", 0.25 * static_cast<double>(context.seed), ""}}, {picture}};
}

const std::vector<thesis::Study> kStudies{
    {"9.98", "first", kClaims, quick}, {"9.97", "second", kClaims, quick}, {"9.96", "third", kClaims, quick}};

TEST(RunStudies, KeepsTheirOrderAndReportsEveryShare) {
  for (const int threads : {1, 2, 5}) {
    double last = 0.0;
    const auto runs = run_studies(kStudies, {}, kSeeds, threads, [&](double share) {
      EXPECT_GE(share, last);
      last = share;
      return true;
    });
    EXPECT_EQ(last, 1.0);
    ASSERT_EQ(runs.size(), 3u);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      EXPECT_EQ(std::string(runs[i].study.number), kStudies[i].number);
      EXPECT_TRUE(runs[i].seeds.front().result.ok());
    }
  }
}

TEST(RunStudies, StopsAllWhenToldTo) {
  const auto runs = run_studies(kStudies, {}, kOneSeed, 2, [](double) { return false; });
  for (const StudyRun& run : runs) {
    ASSERT_FALSE(run.seeds.front().result.ok());
    EXPECT_EQ(run.seeds.front().result.error().message, thesis::stopped().message);
  }
}

TEST(RunStudies, OneThatThrowsLosesNoOther) {
  std::vector<thesis::Study> studies = kStudies;
  studies[1].run = [](const StudyContext&) -> Result<StudyResult> { throw std::runtime_error("no memory"); };
  const auto runs = run_studies(studies, {}, kOneSeed, 2, [](double) { return true; });
  EXPECT_TRUE(runs[0].seeds[0].result.ok());
  ASSERT_FALSE(runs[1].seeds[0].result.ok());
  EXPECT_EQ(runs[1].seeds[0].result.error().message, "no memory");
  EXPECT_TRUE(runs[2].seeds[0].result.ok());
  const auto claims = claims_of(runs[1]);
  ASSERT_EQ(claims.size(), 1u);
  EXPECT_EQ(claims[0].verdict, "fails");
  EXPECT_EQ(claims[0].reason, "the study could not run: no memory");
}

TEST(RunStudies, RunAStudyThatDrawsNothingWithOneSeedAndAnyOtherWithAll) {
  std::vector<thesis::Study> studies = kStudies;
  studies[1].run = drawn;
  const auto runs = run_studies(studies, {}, kSeeds, 2, [](double) { return true; });
  EXPECT_EQ(runs[0].seeds.size(), 1u);
  ASSERT_EQ(runs[1].seeds.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(runs[1].seeds[i].seed, kSeeds[i]);
    ASSERT_TRUE(runs[1].seeds[i].result.ok());
    EXPECT_EQ(runs[1].seeds[i].result.value().measured[0].value, 0.25 * static_cast<double>(kSeeds[i]));
    EXPECT_EQ(runs[1].seeds[i].result.value().pictures.size(), i == 0 ? 1u : 0u);
  }
}

class Folder {
 public:
  Folder()
      : path_((std::filesystem::temp_directory_path() / ("farrier_reproduce_" + std::to_string(::getpid()))).string()) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

TEST(StudyPage, HasEveryPictureBesideItsClaim) {
  const Folder folder;
  const auto runs = run_studies({kStudies.data(), 1}, {}, kOneSeed, 1, [](double) { return true; });
  report::Outcome outcome;
  outcome.command = "reproduce";
  add_claims(outcome, claims_of(runs[0]));
  const auto drawn = draw_studies(folder.path(), runs);
  ASSERT_TRUE(drawn.ok()) << drawn.error().message;
  EXPECT_GT(std::filesystem::file_size(folder.path() + "/pictures/9.98_1.svg"), 1000u);
  const auto page = write_study_page(folder.path(), outcome, runs);
  ASSERT_TRUE(page.ok());
  std::ostringstream html;
  html << std::ifstream(page.value()).rdbuf();
  EXPECT_NE(html.str().find("src=\"pictures/9.98_1.svg\""), std::string::npos);
  EXPECT_NE(html.str().find("the &lt;value&gt; is small"), std::string::npos);
  EXPECT_NE(html.str().find(">holds<"), std::string::npos);
}

}  // namespace reproduce_run_test
}  // namespace farrier::thesis
