// Comments and test names are plain English, as docs/style.md says.

#include <gtest/gtest.h>

#include "documents.hpp"
#include "prose.hpp"

namespace farrier::docs {
namespace prose_test {

using architecture::Source;
using architecture::source_tree;

std::string text_of(const Source& source, const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += architecture::at(source, finding.line) + ": " + finding.rule + ": " + finding.text + "\n";
  }
  return text;
}

TEST(Prose, OfCommentsAndTestNamesIsPlain) {
  const std::vector<std::string> banned = banned_words();
  ASSERT_FALSE(banned.empty()) << "docs/style.md has no table of banned words";
  for (const Source& source : source_tree()) {
    if (source.is_cpp()) {
      const std::vector<Finding> findings = prose_findings(source, banned);
      EXPECT_TRUE(findings.empty()) << text_of(source, findings);
    }
  }
}

TEST(ProseFindings, NameTheSentenceAndTheRule) {
  const Source source{
      "x.cpp",
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
