// farrier: the command of the house. Each subcommand is one function of command.hpp.

#include <cstdio>

#include "tools/cli/command.hpp"

namespace {

struct Subcommand {
  const char* name;
  const char* sentence;
  std::function<int()> (*declare)(CLI::App&);
};

constexpr Subcommand kSubcommands[] = {
    {"bench", "Measure speed as ratios against what a user would pick instead", farrier::cli::declare_bench},
    {"trot", "Run a robot's gait through all processes, judge it and report", farrier::cli::declare_trot},
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Torque control of hydraulic legged robots over DDS", "farrier");
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  std::function<int()> run;
  for (const Subcommand& command : kSubcommands) {
    CLI::App* sub = app.add_subcommand(command.name, command.sentence);
    const auto execute = command.declare(*sub);
    sub->callback([&run, execute] { run = execute; });
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    return app.exit(problem) == 0 ? farrier::cli::kPassed : farrier::cli::kBadInput;
  }
  return run();
}
