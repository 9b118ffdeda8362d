// A command line of farrier that a document shows is one that farrier takes.

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "documents.hpp"
#include <CLI/CLI.hpp>

#include "cli/manual/all_verbs.hpp"
#include "cli/base/command_text.hpp"

namespace farrier::docs {
namespace commands_test {

/// Returns the text after "farrier" in each simple command of a line for sh.
std::vector<std::string> farrier_commands(const std::string& line) {
  static const std::regex comment(R"re((^|\s)#.*$)re");
  static const std::regex separator(R"re([|;&<>()]+)re");
  static const std::regex call(
      R"re(^\s*(?:sudo\s+|ssh \S+\s+)?(?:[A-Z_]+=\S*\s+)*(?:\S*/)?farrier(?:\s+(.*?))?\s*$)re");
  const std::string code = std::regex_replace(line, comment, "");
  std::vector<std::string> commands;
  for (std::sregex_token_iterator part(code.begin(), code.end(), separator, -1), end; part != end; ++part) {
    const std::string text = *part;
    if (std::smatch match; std::regex_match(text, match, call)) {
      commands.push_back(match[1]);
    }
  }
  return commands;
}

/// `./farrier test` and `docs` are of the script, which hands the rest to the command.
bool is_of_the_script(const std::string& arguments) {
  static const std::regex first(R"re(^(test|docs)\b)re");
  return std::regex_search(arguments, first);
}

/// Returns the parser's objection, empty if there is none.
std::string refusal(const std::string& arguments) {
  std::function<int()> run;
  const auto app = cli::command_line(cli::all_verbs(), run);
  try {
    app->parse(arguments, false);
  } catch (const CLI::ParseError& problem) {
    return problem.get_exit_code() == 0 ? "" : problem.what();
  }
  return run ? "" : "no command";
}

/// Lines with those that "\" continues joined.
std::vector<Line> joined(const std::vector<Line>& lines) {
  std::vector<Line> all;
  bool goes_on = false;
  for (const Line& line : lines) {
    if (goes_on) {
      all.back().text += " " + line.text;
    } else {
      all.push_back(line);
    }
    std::string& text = all.back().text;
    goes_on = text.ends_with("\\");
    if (goes_on) {
      text.pop_back();
    }
  }
  return all;
}

TEST(Commands, InBlocksForTheShellAreTaken) {
  int checked = 0;
  for (const Document& document : documents()) {
    for (const Block& block : document.blocks) {
      if (block.language != "sh") {
        continue;
      }
      for (const Line& line : joined(block.lines)) {
        for (const std::string& arguments : farrier_commands(line.text)) {
          if (!is_of_the_script(arguments)) {
            ++checked;
            EXPECT_EQ(refusal(arguments), "") << at(document, line) << ": " << line.text;
          }
        }
      }
    }
  }
  EXPECT_GT(checked, 20) << "the test must find the commands";
}

// In a sentence a command may be short of arguments or name several; command and options must be there.
TEST(Commands, InSentencesNameCommandsAndOptionsThatAreThere) {
  static const std::regex command(R"re(^(?:\./)?farrier ([a-z]+))re");
  static const std::regex option(R"re((?:^|\s)(--[a-z0-9-]+))re");
  std::function<int()> run;
  const auto app = cli::command_line(cli::all_verbs(), run);
  const std::vector<cli::CommandText> commands = cli::command_texts(*app);
  for (const Document& document : documents()) {
    for (const Line& line : document.prose) {
      for (const std::string& span : code_spans(line.text)) {
        std::smatch match;
        if (!std::regex_search(span, match, command) || match[1] == "test" || match[1] == "docs") {
          continue;
        }
        const auto known = std::ranges::find(commands, match[1].str(), &cli::CommandText::name);
        if (known == commands.end()) {
          ADD_FAILURE() << at(document, line) << ": no such command: " << span;
          continue;
        }
        for (std::sregex_iterator named(span.begin(), span.end(), option), end; named != end; ++named) {
          EXPECT_TRUE(std::ranges::any_of(
              known->options,
              [&](const cli::OptionText& o) { return std::ranges::find(o.names, (*named)[1].str()) != o.names.end(); }))
              << at(document, line) << ": no such option: " << span;
        }
      }
    }
  }
}

TEST(Commands, ThatAreNotTakenAreFound) {
  EXPECT_EQ(refusal("trot --dds fast"), "");
  EXPECT_EQ(refusal("--version"), "");
  EXPECT_NE(refusal("trot --dds zenoh"), "");
  EXPECT_NE(refusal("trot --duraton 4"), "");
  EXPECT_NE(refusal("canter"), "");
  EXPECT_NE(refusal("request arm"), "") << "--session is required";
  EXPECT_EQ(farrier_commands("FARRIER_DDS=fast ./farrier trot --soak  # why | what"),
            (std::vector<std::string>{"trot --soak"}));
  EXPECT_EQ(farrier_commands("farrier tables cli > docs/cli.md && sudo farrier doctor"),
            (std::vector<std::string>{"tables cli", "doctor"}));
  EXPECT_TRUE(farrier_commands("cat /etc/farrier/hyq.yaml").empty());
}

}  // namespace commands_test
}  // namespace farrier::docs
