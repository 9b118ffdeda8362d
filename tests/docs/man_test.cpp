// Manual pages say what the command takes, in a form that formatters take without a warning.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "documents.hpp"
#include "tests/support/scratch_directory.hpp"
#include <CLI/CLI.hpp>

#include "cli/manual/all_verbs.hpp"
#include "cli/base/command_text.hpp"
#include "cli/manual/man_page.hpp"

namespace farrier::docs {
namespace man_test {

namespace fs = std::filesystem;

const std::vector<cli::CommandText>& commands() {
  static const std::vector<cli::CommandText> all = [] {
    std::function<int()> run;
    return cli::command_texts(*cli::command_line(cli::all_verbs(), run));
  }();
  return all;
}

std::string format(const fs::path& page, const std::string& options) {
  const Ran formatted = run("LC_ALL=C.UTF-8 groff -man -Tutf8 -rLL=200n -P-c " + options + " '" + page.string() + "'");
  EXPECT_EQ(formatted.status, 0) << formatted.output;
  return formatted.output;
}

/// As a terminal would show it, without bold and italics.
std::string shown(const fs::path& page) {
  std::string text;
  const std::string formatted = format(page, "-P-b -P-u");
  for (std::size_t i = 0; i < formatted.size(); ++i) {
    if (i + 1 < formatted.size() && formatted[i + 1] == '\b') {
      ++i;
    } else {
      text += formatted[i];
    }
  }
  return text;
}

class Pages : public ::testing::Test {
 protected:
  Pages() {
    const Ran made = run(FARRIER_COMMAND " man --out '" + scratch_.file("man1") + "'");
    EXPECT_EQ(made.status, 0) << made.output;
  }
  fs::path page(const std::string& name) const { return scratch_.file("man1/" + name + ".1"); }

  test::ScratchDirectory scratch_;
};

TEST_F(Pages, AreThereForFarrierAndForEachCommand) {
  EXPECT_TRUE(fs::exists(page("farrier")));
  for (const cli::CommandText& command : commands()) {
    EXPECT_TRUE(fs::exists(page("farrier-" + command.name))) << command.name;
  }
}

TEST_F(Pages, AreFormattedWithoutAWarning) {
  for (const auto& entry : fs::directory_iterator(scratch_.file("man1"))) {
    EXPECT_EQ(format(entry.path(), "-ww -z"), "") << entry.path();
  }
}

TEST_F(Pages, ShowEveryOptionWithItsMeaning) {
  for (const cli::CommandText& command : commands()) {
    const std::string text = shown(page("farrier-" + command.name));
    for (const cli::OptionText& option : command.options) {
      EXPECT_NE(text.find(cli::heading_of(option)), std::string::npos) << command.name << ": " << heading_of(option);
      EXPECT_NE(text.find(option.meaning.substr(0, 20)), std::string::npos) << command.name << ": " << option.meaning;
    }
  }
}

TEST_F(Pages, BeginAsIndexesOfManualPagesExpect) {
  EXPECT_NE(shown(page("farrier-trot")).find("farrier-trot - Run a robot's gait"), std::string::npos)
      << shown(page("farrier-trot"));
}

TEST(Page, KeepsWhatTheFormatterWouldTakeForItself) {
  cli::OptionText odd;
  odd.names = {"--odd"};
  odd.meaning = ".starts with a dot, has 'quotes' and a \\ in it";
  const test::ScratchDirectory scratch;
  std::ofstream(scratch.file("odd.1")) << cli::man_pages({"", "Farrier", {}}, {{"odd", "Odd", {odd}}}, "1").at("farrier-odd.1");
  EXPECT_EQ(format(scratch.file("odd.1"), "-ww -z"), "");
  EXPECT_NE(shown(scratch.file("odd.1")).find(odd.meaning), std::string::npos) << shown(scratch.file("odd.1"));
}

}  // namespace man_test
}  // namespace farrier::docs
