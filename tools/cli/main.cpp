// farrier: the command of the house. Each subcommand is one function of command.hpp.

#include <algorithm>
#include <cstdio>
#include <string_view>

#include "tools/cli/command.hpp"
#include "tools/cli/help.hpp"

namespace {

struct Subcommand {
  const char* name;
  const char* sentence;
  std::function<int()> (*declare)(CLI::App&);
};

constexpr Subcommand kSubcommands[] = {
    {"trot", "Run a robot's gait through all processes, judge it and report", farrier::cli::declare_trot},
    {"bench", "Measure speed as ratios against what a user would pick instead", farrier::cli::declare_bench},
    {"convert", "Make CSV files of a recording, and a recording of them", farrier::cli::declare_convert},
    {"deploy", "Render what each computer of a robot needs, and check this one against it",
     farrier::cli::declare_deploy},
    {"diagnose", "Find what a joint's model lacks from what was recorded of the joint", farrier::cli::declare_diagnose},
    {"doctor", "Say why no data comes, or no real time is had, and what to do about it", farrier::cli::declare_doctor},
    {"echo", "Print what a running robot's processes publish", farrier::cli::declare_echo},
    {"faults", "Make faults happen to a trot of real processes and judge what each process does", farrier::cli::declare_faults},
    {"info", "Say what a recording holds, of which run, and what it lacks", farrier::cli::declare_info},
    {"monitor", "Show a running robot: a table on the terminal, metrics for Prometheus, a page", farrier::cli::declare_monitor},
    {"record", "Record everything a running robot's processes publish, as MCAP", farrier::cli::declare_record},
    {"replay", "Publish a recording as the processes of its robot did", farrier::cli::declare_replay},
    {"reproduce", "Run the studies of the thesis anew and judge its claims", farrier::cli::declare_reproduce},
    {"request", "Ask a running robot's supervisor to arm or to stop it", farrier::cli::declare_request},
    {"security", "Make or check the keys and permissions for DDS Security", farrier::cli::declare_security},
    {"tables", "Print the generated tables of the documentation", farrier::cli::declare_tables},
    {"topics", "List who writes and reads what of a running robot, and how often", farrier::cli::declare_topics},
};

bool is_subcommand(std::string_view name) {
  return std::any_of(std::begin(kSubcommands), std::end(kSubcommands),
                     [&](const Subcommand& command) { return name == command.name; });
}

}  // namespace

int main(int argc, char** argv) {
  using namespace farrier::cli;
  if (argc > 1 && argv[1][0] != '-' && !is_subcommand(argv[1])) {
    std::fprintf(stderr, "farrier: '%s' is not a farrier command\nsee 'farrier --help'\n", argv[1]);
    return kBadInput;
  }
  CLI::App app("Torque control of hydraulic legged robots over DDS", "farrier");
  use_help(app);
  std::function<int()> run;
  for (const Subcommand& command : kSubcommands) {
    CLI::App* sub = app.add_subcommand(command.name, command.sentence);
    const auto execute = command.declare(*sub);
    sub->callback([&run, execute] { run = execute; });
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    return app.exit(problem) == 0 ? kPassed : kBadInput;
  }
  if (!run) {
    std::fputs(app.help().c_str(), stderr);
    return kBadInput;
  }
  return run();
}
