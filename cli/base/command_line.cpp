#include "cli/base/command_line.hpp"

#include <algorithm>

#include "cli/base/command.hpp"
#include "cli/base/help.hpp"
#include "report/figures/run_info.hpp"

namespace farrier::cli {
namespace {

struct Subcommand {
  const char* name;
  const char* sentence;
  std::function<int()> (*declare)(CLI::App&);
};

constexpr Subcommand kSubcommands[] = {
    {"trot", "Run a robot's gait through all processes, judge it and report", declare_trot},
    {"bench", "Measure speed as ratios against what a user would pick instead", declare_bench},
    {"completion", "Print what makes a shell complete farrier's commands and options", declare_completion},
    {"convert", "Make CSV files of a recording, and a recording of them", declare_convert},
    {"deploy", "Render what each computer of a robot needs, and check this one against it",
     declare_deploy},
    {"diagnose", "Find what a joint's model lacks from what was recorded of the joint", declare_diagnose},
    {"doctor", "Say why no data comes, or no real time is had, and what to do about it", declare_doctor},
    {"echo", "Print what a running robot's processes publish", declare_echo},
    {"faults", "Make faults happen to a trot of real processes and judge what each process does", declare_faults},
    {"identify", "Estimate every joint of a recording anew, over time", declare_identify},
    {"info", "Say what a recording holds, of which run, and what it lacks", declare_info},
    {"man", "Write the manual pages of farrier and of each command", declare_man},
    {"monitor", "Show a running robot: a table on the terminal, metrics for Prometheus, a page", declare_monitor},
    {"record", "Record everything a running robot's processes publish, as MCAP", declare_record},
    {"replay", "Publish a recording as the processes of its robot did", declare_replay},
    {"reproduce", "Run the studies of the thesis anew and judge its claims", declare_reproduce},
    {"request", "Ask a running robot's supervisor to arm or to stop it", declare_request},
    {"security", "Make or check the keys and permissions for DDS Security", declare_security},
    {"tables", "Print the generated tables of the documentation", declare_tables},
    {"topics", "List who writes and reads what of a running robot, and how often", declare_topics},
};

}  // namespace

std::unique_ptr<CLI::App> command_line(std::function<int()>& run) {
  auto app = std::make_unique<CLI::App>("Torque control of hydraulic legged robots over DDS", "farrier");
  use_help(*app);
  app->set_version_flag("--version", "farrier " + report::build_name(), "print version and git revision");
  for (const Subcommand& command : kSubcommands) {
    CLI::App* sub = app->add_subcommand(command.name, command.sentence);
    const auto execute = command.declare(*sub);
    sub->callback([&run, execute] { run = execute; });
  }
  return app;
}

bool is_command(std::string_view name) {
  return std::ranges::find(kSubcommands, name, &Subcommand::name) != std::end(kSubcommands);
}

}  // namespace farrier::cli
