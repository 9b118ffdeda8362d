// Comments and test names are plain English. Files that were written before this rule have a pinned number of findings,
// which may only fall.

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <numeric>
#include <sstream>

#include "documents.hpp"
#include "prose.hpp"

namespace farrier::docs {
namespace prose_test {

using architecture::source_tree;
using architecture::Source;

constexpr const char* kPins = "tests/docs/prose_findings.txt";
using Counts = std::map<std::string, std::size_t>;  ///< by path; without files that have none

/// Lines "number path".
Counts read_counts(std::istream& stream) {
  Counts counts;
  std::size_t count = 0;
  for (std::string path; stream >> count >> path;) {
    counts[path] = count;
  }
  return counts;
}

std::size_t sum(const Counts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0},
                         [](std::size_t total, const auto& entry) { return total + entry.second; });
}

std::string text_of(const Source& source, const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += architecture::at(source, finding.line) + ": " + finding.rule + ": " + finding.text + "\n";
  }
  return text;
}

TEST(Prose, HasNoMoreFindingsThanArePinned) {
  std::ifstream file(FARRIER_SOURCE_DIR + std::string("/") + kPins);
  const Counts pinned = read_counts(file);
  const std::vector<std::string> banned = banned_words();
  ASSERT_FALSE(banned.empty()) << "docs/style.md has no table of banned words";
  Counts counts;
  for (const Source& source : source_tree()) {
    if (!source.is_cpp()) {
      continue;
    }
    const std::vector<Finding> findings = prose_findings(source, banned);
    const auto pin = pinned.find(source.path);
    if (!findings.empty()) {
      counts[source.path] = findings.size();
    }
    EXPECT_LE(findings.size(), pin == pinned.end() ? 0 : pin->second) << text_of(source, findings);
  }
  std::ofstream now("prose_findings.txt");
  for (const auto& [path, count] : counts) {
    now << count << ' ' << path << '\n';
  }
  std::printf("%zu findings in %zu files\n", sum(counts), counts.size());
  EXPECT_EQ(sum(counts), sum(pinned)) << "there are fewer findings than are pinned: copy prose_findings.txt of the build's "
                                      << "directory to " << kPins;
}

TEST(Prose, PinsFallFromOneChangeToTheNext) {
  const std::string base = base_of_the_change();
  const std::string before = git("show " + base + ":" + kPins);
  if (base.empty() || before.empty()) {
    GTEST_SKIP() << "no earlier numbers to compare with";
  }
  std::istringstream earlier(before);
  std::ifstream file(FARRIER_SOURCE_DIR + std::string("/") + kPins);
  EXPECT_LE(sum(read_counts(file)), sum(read_counts(earlier)));
}

TEST(Prose, HasNoFindingInAFileThatTheChangeTouches) {
  const std::string base = base_of_the_change();
  if (base.empty() || git("show " + base + ":" + kPins).empty()) {
    GTEST_SKIP() << "no history that has this rule";
  }
  const std::vector<std::string> banned = banned_words();
  for (const std::string& path : changed_files()) {
    const Source* source = architecture::find_source(path);
    if (source != nullptr && source->is_cpp()) {
      const std::vector<Finding> findings = prose_findings(*source, banned);
      EXPECT_TRUE(findings.empty()) << text_of(*source, findings);
    }
  }
}

TEST(ProseFindings, NameTheSentenceAndTheRule) {
  const Source source{"x.cpp",
                      {"// Returns nothing. Of all joints the last,", "// whose name is long.", "int a = 0;  // What it is",
                       "const char* s = \"// Of a string\";", "TEST(Flag, RefusesAFlagThatIsNone) {"}};
  const std::vector<Finding> findings = prose_findings(source, {"whose name"});
  ASSERT_EQ(findings.size(), 4u);
  EXPECT_EQ(findings[0].line, 1);
  EXPECT_EQ(findings[0].rule, "begins with 'Of'");
  EXPECT_EQ(findings[0].text, "Of all joints the last, whose name is long.");
  EXPECT_EQ(findings[1].rule, "has the banned 'whose name'");
  EXPECT_EQ(findings[2].line, 3);
  EXPECT_EQ(findings[3].text, "RefusesAFlagThatIsNone");
}

TEST(ProseFindings, CountWordsOfASentenceAndLeaveQuestionsAlone) {
  std::string words = "// A";
  for (int i = 0; i < 35; ++i) {
    words += " word";
  }
  EXPECT_EQ(prose_findings({"x.cpp", {words + "."}}, {}).size(), 1u);
  EXPECT_EQ(prose_findings({"x.cpp", {words.substr(0, words.size() - 5) + "."}}, {}).size(), 0u);
  EXPECT_EQ(prose_findings({"x.cpp", {"// What is this?"}}, {}).size(), 0u);
}

}  // namespace prose_test
}  // namespace farrier::docs
