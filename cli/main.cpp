// farrier: the command of the house. Each subcommand is one function of command.hpp.

#include <cstdio>

#include "cli/base/command.hpp"
#include "cli/base/command_line.hpp"

int main(int argc, char** argv) {
  using namespace farrier::cli;
  if (argc > 1 && argv[1][0] != '-' && !is_command(argv[1])) {
    std::fprintf(stderr, "farrier: '%s' is not a farrier command\nsee 'farrier --help'\n", argv[1]);
    return kBadInput;
  }
  std::function<int()> run;
  const auto app = command_line(run);
  try {
    app->parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    return app->exit(problem) == 0 ? kPassed : kBadInput;
  }
  if (!run) {
    std::fputs(app->help().c_str(), stderr);
    return kBadInput;
  }
  return run();
}
