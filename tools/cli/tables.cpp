// farrier tables: what can rot in the documentation is printed from the code; a test compares it with the files.

#include <cstdio>
#include <map>

#include "bus/topics.hpp"
#include "robot/robot.hpp"
#include "tools/cli/command.hpp"
#include "tools/cli/help.hpp"
#include "tools/monitor/metric_table.hpp"
#include "tools/report/effects_table.hpp"
#include "tools/report/figures.hpp"

namespace farrier::cli {
namespace {

using Table = std::string (*)();
const std::map<std::string, Table> kTables{{"topics", bus::topics_table_markdown},
                                           {"effects", report::effects_table_markdown},
                                           {"figures", report::figures_table_markdown},
                                           {"metrics", display::metrics_table_markdown},
                                           {"parameters", robot::parameter_table}};

}  // namespace

std::function<int()> declare_tables(CLI::App& app) {
  auto table = std::make_shared<Table>(nullptr);
  add_choice(app, "table", *table, kTables, "topics|effects|figures|metrics|parameters",
             "topics (idl/README.md), effects (docs/effects.md), figures (docs/figures.md), metrics "
             "(docs/metrics.md) or parameters (docs/parameters.md)")
      ->required();
  return [table] {
    std::fputs((*table)().c_str(), stdout);
    return kPassed;
  };
}

}  // namespace farrier::cli
