// Runs the shells and checks the completions that they offer.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "documents.hpp"
#include "tests/support/scratch_directory.hpp"

namespace farrier::docs {
namespace completion_test {

using Words = std::set<std::string>;

/// A folder with a few files, in which shells are asked.
class Shells : public ::testing::Test {
 protected:
  Shells() {
    const std::ofstream made(scratch_.file("robot one.yaml"));
    std::filesystem::create_directory(scratch_.file("keys"));
    for (const char* shell : {"bash", "zsh", "fish"}) {
      const Ran printed = run(FARRIER_COMMAND " completion " + std::string(shell));
      EXPECT_EQ(printed.status, 0) << printed.output;
      std::ofstream(scratch_.file(std::string("_") + shell)) << printed.output;
    }
  }

  static Words lines_of(const std::string& text) {
    Words words;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      words.insert(line);
    }
    return words;
  }

  Ran in_scratch(const std::string& script, const std::string& shell) const {
    std::ofstream(scratch_.file("script")) << script;
    return run("cd '" + scratch_.file("") + "' && " + shell + " script");
  }

  /// Returns bash's completions of the last word. `words` is the text in COMP_WORDS.
  Words bash(const std::string& words) const {
    const Ran ran = in_scratch("source ./_bash\nCOMP_WORDS=(" + words +
                                   ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_farrier\n"
                                   "for word in \"${COMPREPLY[@]}\"; do echo \"$word\"; done\n",
                               "bash --norc -eu");
    EXPECT_EQ(ran.status, 0) << ran.output;
    return lines_of(ran.output);
  }

  Words fish(const std::string& line) const {
    const Ran ran = in_scratch("source ./_fish\ncomplete -C '" + line + "' | string replace -r '\\t.*' ''; true\n",
                               "HOME=. XDG_CONFIG_HOME=. fish --no-config");
    EXPECT_EQ(ran.status, 0) << ran.output;
    return lines_of(ran.output);
  }

  /// Returns zsh's completions of each line. One zsh answers all, for it takes seconds to begin.
  std::vector<Words> zsh(const std::vector<std::string>& lines) const {
    std::string command = "cd '" + scratch_.file("") + "' && timeout 60 zsh -f " FARRIER_ASK_ZSH;
    for (const std::string& line : lines) {
      command += " '" + line + "'";
    }
    const Ran ran = run(command);
    EXPECT_EQ(ran.status, 0) << ran.output;
    std::vector<Words> words(1);
    std::istringstream stream(ran.output);
    for (std::string word; std::getline(stream, word);) {
      if (word.empty()) {
        words.emplace_back();
      } else {
        words.back().insert(word);
      }
    }
    words.pop_back();
    return words;
  }

  test::ScratchDirectory scratch_;
};

TEST_F(Shells, OfBashOfferCommandsAndOptions) {
  EXPECT_EQ(bash("farrier re"), (Words{"record", "replay", "reproduce", "request"}));
  EXPECT_EQ(bash("farrier --v"), (Words{"--version"}));
  EXPECT_EQ(bash("farrier trial --see"), (Words{"--seed", "--seeds"}));
  EXPECT_EQ(bash("farrier canter --"), Words{});
}

TEST_F(Shells, OfBashOfferWhatAnOptionTakes) {
  EXPECT_EQ(bash("farrier trot --dds ''"), (Words{"cyclone", "fast", "mixed", "inproc"}));
  EXPECT_EQ(bash("farrier trot --dds = f"), (Words{"fast"})) << "bash splits --dds=f";
  EXPECT_EQ(bash("farrier record --dds ''"), (Words{"cyclone", "fast"}));
  EXPECT_EQ(bash("farrier record --topics clock/tick,gait/"), (Words{"clock/tick,gait/phase"}));
  EXPECT_EQ(bash("farrier trot --robot ro"), (Words{"robot one.yaml"}));
  EXPECT_EQ(bash("farrier trot --security ''"), (Words{"keys"}));
  EXPECT_EQ(bash("farrier trot --duration ''"), Words{});
}

TEST_F(Shells, OfBashOfferWhatStandsAtAPlace) {
  EXPECT_EQ(bash("farrier deploy ''"), (Words{"render", "check"}));
  EXPECT_EQ(bash("farrier deploy --host front ''"), (Words{"render", "check"})) << "front is the option's";
  EXPECT_EQ(bash("farrier deploy render ro"), (Words{"robot one.yaml"}));
  EXPECT_EQ(bash("farrier echo clock/tick gait/"), (Words{"gait/phase"}));
  EXPECT_EQ(bash("farrier completion ''"), (Words{"bash", "zsh", "fish"}));
}

TEST_F(Shells, OfFishOfferTheSame) {
  if (run("command -v fish").status != 0) {
    GTEST_SKIP() << "fish is not installed";
  }
  EXPECT_EQ(fish("farrier re"), (Words{"record", "replay", "reproduce", "request"}));
  EXPECT_EQ(fish("farrier trot --dds "), (Words{"cyclone", "fast", "mixed", "inproc"}));
  EXPECT_EQ(fish("farrier tables ").count("cli"), 1u);
  EXPECT_EQ(fish("farrier tables --").count("--look"), 0u) << "that is of farrier topics";
  EXPECT_EQ(fish("farrier trot --security k"), (Words{"keys/"}));
  EXPECT_EQ(fish("farrier trot --robot ro").count("robot one.yaml"), 1u);
}

TEST_F(Shells, OfZshOfferTheSame) {
  if (run("command -v zsh").status != 0) {
    GTEST_SKIP() << "zsh is not installed";
  }
  const std::vector<Words> offers =
      zsh({"farrier re", "farrier trot --dds ", "farrier trial --see", "farrier deploy ",
           "farrier record --topics clock/tick,gait/", "farrier trot --security k", "farrier echo clock/tick gait/"});
  ASSERT_EQ(offers.size(), 7u);
  EXPECT_EQ(offers[0], (Words{"record", "replay", "reproduce", "request"}));
  EXPECT_EQ(offers[1], (Words{"cyclone", "fast", "mixed", "inproc"}));
  EXPECT_EQ(offers[2], (Words{"--seed", "--seeds"}));
  EXPECT_EQ(offers[3], (Words{"render", "check"}));
  EXPECT_EQ(offers[4], (Words{"gait/phase"}));
  EXPECT_EQ(offers[5].count("keys"), 1u);
  EXPECT_EQ(offers[6], (Words{"gait/phase"}));
}

}  // namespace completion_test
}  // namespace farrier::docs
