// farrier completion: what a shell reads to complete farrier's command line, from the options as they are declared.

#include "cli/manual/completion.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>

#include "cli/base/command.hpp"
#include "cli/manual/all_verbs.hpp"
#include "cli/base/help.hpp"

namespace farrier::cli {
namespace {

using Completion = std::string (*)(const CommandText& farrier, const std::vector<CommandText>& commands);
const std::map<std::string, Completion> kShells{
    {"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}};

}  // namespace

std::string quoted(const std::string& text) {
  std::string inside;
  for (const char c : text) {
    inside += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return "'" + inside + "'";
}

std::function<int()> declare_completion(CLI::App& app) {
  auto shell = std::make_shared<Completion>(nullptr);
  add_choice(app, "shell", *shell, kShells, "bash|zsh|fish",
             "the shell; a package installs what this prints, and 'source <(farrier completion bash)' tries it")
      ->required();
  return [shell] {
    const auto whole = whole_command_line();
    const CLI::App& farrier = *whole;
    std::fputs((*shell)(command_text(farrier), command_texts(farrier)).c_str(), stdout);
    return kPassed;
  };
}

}  // namespace farrier::cli
