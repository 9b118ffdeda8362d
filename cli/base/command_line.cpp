#include "cli/base/command_line.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

#include "cli/base/command.hpp"
#include "cli/base/help.hpp"
#include "cli/base/installation.hpp"
#include "cli/base/renamed_options.hpp"
#include "cli/base/standard_output.hpp"
#include "cli/base/verbs.hpp"
#include "report/figures/run_info.hpp"

namespace farrier::cli {
namespace {

/// Becomes the program of the verb. Returns only when that is not there.
int start_program(const Verb& verb, std::vector<std::string> arguments) {
  const std::string program = program_path(std::string(verb.program));
  std::vector<char*> argv;
  for (std::string& argument : arguments) {
    argv.push_back(argument.data());
  }
  argv.push_back(nullptr);
  ::execv(program.c_str(), argv.data());
  std::fprintf(
      stderr,
      "farrier %s: %s is not there: './farrier %s' in the source tree builds it, the package farrier-tools has it\n",
      arguments[1].c_str(), program.c_str(), arguments[1].c_str());
  return kBadInput;
}

}  // namespace

std::unique_ptr<CLI::App> command_line(std::span<const DeclaredVerb> declared, std::function<int()>& run) {
  auto app = std::make_unique<CLI::App>("Torque control of hydraulic legged robots over DDS", "farrier");
  use_help(*app);
  app->set_version_flag("--version", "farrier " + report::build_name(), "print version and git revision");
  for (const DeclaredVerb& verb : declared) {
    CLI::App* sub = app->add_subcommand(verb.name, std::string(find_verb(verb.name)->sentence));
    const auto execute = verb.declare(*sub);
    sub->callback([&run, execute] { run = execute; });
  }
  return app;
}

int run_program(std::span<const DeclaredVerb> declared, int argc, char** argv) {
  const std::vector<std::string> arguments = with_new_names({argv, argv + argc});
  if (arguments.size() > 1 && arguments[1][0] != '-') {
    const Verb* const verb = find_verb(arguments[1]);
    if (verb == nullptr) {
      std::fprintf(stderr, "farrier: '%s' is not a farrier command\nsee 'farrier --help'\n", arguments[1].c_str());
      return kBadInput;
    }
    if (std::ranges::find(declared, verb->name, &DeclaredVerb::name) == declared.end()) {
      return start_program(*verb, arguments);
    }
  }
  std::function<int()> run;
  const auto app = command_line(declared, run);
  prepare_standard_streams();
  try {
    app->parse(std::vector<std::string>(arguments.rbegin(), arguments.rend() - 1));
  } catch (const CLI::ParseError& problem) {
    return status_of_output("", app->exit(problem) == 0 ? kPassed : kBadInput);
  }
  if (!run) {
    std::fputs(app->help().c_str(), stderr);
    return kBadInput;
  }
  return status_of_output(arguments[1], run());
}

}  // namespace farrier::cli
