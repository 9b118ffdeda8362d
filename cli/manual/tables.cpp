// farrier tables: what can rot in the documentation is printed from the code; a test compares it with the files.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>

#include "bus/topics.hpp"
#include "core/fault.hpp"
#include "participant/event_registry.hpp"
#include "robot/robot.hpp"
#include "cli/base/command.hpp"
#include "cli/manual/all_verbs.hpp"
#include "cli/manual/command_table.hpp"
#include "cli/base/help.hpp"
#include "tools/faults/fault_page.hpp"
#include "tools/monitor/metric_table.hpp"
#include "report/diagnosis/effects_table.hpp"
#include "report/figures/figures.hpp"

namespace farrier::cli {
namespace {

/// Some are of the app itself.
using Table = std::function<std::string(const CLI::App& farrier)>;

Table without_app(std::string (*table)()) {
  return [table](const CLI::App&) { return table(); };
}

const std::map<std::string, Table> kTables{{"cli", command_table},
                                           {"topics", without_app(bus::topics_table_markdown)},
                                           {"effects", without_app(report::effects_table_markdown)},
                                           {"events", without_app(participant::events_table_markdown)},
                                           {"faults", without_app(faults::faults_table_markdown)},
                                           {"figures", without_app(report::figures_table_markdown)},
                                           {"metrics", without_app(display::metrics_table_markdown)},
                                           {"parameters", without_app(robot::parameter_table)},
                                           {"safety", without_app(safety_table_markdown)}};

}  // namespace

std::function<int()> declare_tables(CLI::App& app) {
  auto table = std::make_shared<Table>();
  add_choice(app, "table", *table, kTables, "cli|topics|effects|events|faults|figures|metrics|parameters|safety",
             "cli (docs/cli.md), topics (idl/README.md), effects (docs/effects.md), events (docs/events.md), faults "
             "(docs/faults.md), figures (docs/figures.md), "
             "metrics (docs/metrics.md), parameters (docs/parameters.md) or safety (docs/architecture.md)")
      ->required();
  return [table] {
    std::fputs((*table)(*whole_command_line()).c_str(), stdout);
    return kPassed;
  };
}

}  // namespace farrier::cli
