// farrier faults: every row of the table of faults made to happen to a trot of real processes, and judged.

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "participant/loop.hpp"
#include "process/process.hpp"
#include "cli/base/command.hpp"
#include "cli/base/help.hpp"
#include "cli/faults/fault_run.hpp"
#include "cli/base/installation.hpp"
#include "cli/base/output_file.hpp"
#include "tools/faults/cells_file.hpp"
#include "tools/faults/fault_page.hpp"
#include "report/figures/console.hpp"
#include "core/replace_file.hpp"
#include "report/figures/outcome.hpp"
#include "report/figures/run_info.hpp"
#include "trace/body_trace.hpp"

namespace farrier::cli {
namespace {

namespace fs = std::filesystem;

struct FaultsOptions {
  std::string robot_path = shipped_robot("hyq.yaml");
  std::vector<std::string> rows;
  std::vector<std::string> vendors{"cyclone", "fast"};
  int seeds = 3;
  int cells = 0;           ///< to be drawn; 0: all
  std::uint64_t seed = 1;  ///< of the draw
  int slow = 3;
  int most_repeats = 10;
  participant::World world = participant::World::kBench;
  std::string out = "out/faults";
  std::string json_path, page_path;
  bool go_on = false;
};

/// The worst of the bodies in the cells of a row. A fall by itself breaks no bound: joints react to faults as the row
/// says, which may let a walking robot down. Rows under which it walks on have a check of that.
void add_body(report::Figures& figures, const std::vector<faults::Cell>& cells, const std::string& row) {
  const auto worst = faults::worst_body(cells, row);
  if (!worst) {
    return;
  }
  const auto fell = [&](const faults::Cell& cell) { return cell.row == row && cell.fell(); };
  figures.add("faults." + row + ".falls", static_cast<double>(std::ranges::count_if(cells, fell)));
  figures.add("faults." + row + ".trunk_speed_m_s", worst->trunk_speed_m_s);
  figures.add("faults." + row + ".ground_force_N", worst->ground_force_N);
}

/// A cell that was not run has not held.
report::Outcome outcome_of(const robot::Robot& robot, const std::vector<faults::Cell>& cells, std::size_t planned) {
  report::Outcome outcome;
  outcome.command = "faults";
  outcome.run = report::run_info(robot, 1);
  int repeats = 0;
  for (const faults::Cell& cell : cells) {
    repeats += cell.repeats;
    if (!cell.error.empty()) {
      outcome.failures.push_back(faults::place_text(cell) + ": " + cell.error);
    }
  }
  outcome.figures.add("faults.cells", static_cast<double>(planned));
  outcome.figures.add("faults.repeats", repeats);
  outcome.figures.add("faults.held", static_cast<double>(std::ranges::count_if(cells, &faults::Cell::holds)),
                      static_cast<double>(planned));
  if (std::ranges::any_of(cells, [](const faults::Cell& cell) { return cell.body.has_value(); })) {
    outcome.figures.add("faults.falls", static_cast<double>(std::ranges::count_if(cells, &faults::Cell::fell)));
  }
  for (const faults::Row& row : faults::rows()) {
    add_body(outcome.figures, cells, row.name);
    for (const faults::Check& check : faults::worst_checks(cells, row.name)) {
      outcome.figures.add("faults." + std::string(row.name) + "." + check.key + "_ms", check.measured_s * 1e3,
                          check.asked_s * 1e3);
    }
  }
  return outcome;
}

/// Cells that were run, and why some of them are not kept for --continue; empty: all are.
struct Ran {
  std::vector<faults::Cell> cells;
  std::string not_kept;
};

report::Outcome outcome_of(const robot::Robot& robot, const Ran& ran, std::size_t planned) {
  report::Outcome outcome = outcome_of(robot, ran.cells, planned);
  if (!ran.not_kept.empty()) {
    outcome.failures.push_back("cells are not kept: " + ran.not_kept);
  }
  return outcome;
}

/// Names a cell that did not hold or in which the robot fell, and keeps its traces in files of its name.
void tell_and_keep(const faults::CellPlan& plan, const faults::Cell& cell, const std::string& out) {
  if (cell.holds() && !cell.fell()) {
    return;
  }
  const std::string place = faults::place_text(cell);
  std::fprintf(stderr, "%s: %s\n", place.c_str(),
               cell.holds() ? "held, and the robot fell" : faults::why_not(cell).c_str());
  if (!faults::leaves_trace(*plan.row) || !cell.error.empty()) {
    return;  // the trace is that of another cell
  }
  const std::string from = out + "/trace.csv", to = out + "/" + place + ".csv";
  std::error_code refused;
  fs::copy_file(from, to, fs::copy_options::overwrite_existing, refused);
  if (cell.body) {
    fs::copy_file(trace::body_trace_path(from), trace::body_trace_path(to), fs::copy_options::overwrite_existing,
                  refused);
  }
}

/// The cells of `plans`, or those until the user interrupts. Cells that held are kept in a file; with --continue what held
/// in an earlier run is not run again. After every cell the figures so far are written, which do not hold before the last.
Ran run_all(const robot::Robot& robot, const FaultsOptions& o, const std::vector<faults::CellPlan>& plans) {
  const report::RunInfo info = report::run_info(robot, 1);
  const faults::CellsOrigin origin{info.git_revision, info.configuration_hash, o.slow,
                                   name_of(participant::kWorlds, o.world)};
  const std::string kept_path = o.out + "/cells.jsonl";
  if (!o.go_on) {
    std::error_code none;
    fs::remove(kept_path, none);
  }
  const std::vector<faults::Cell> kept = faults::read_cells(kept_path, origin);
  Ran ran;
  std::vector<faults::Cell>& cells = ran.cells;
  PauseWatch pauses;
  for (const faults::CellPlan& plan : plans) {
    const std::string place = faults::place_text(plan.cell());
    const auto known =
        std::ranges::find_if(kept, [&](const faults::Cell& cell) { return faults::place_text(cell) == place; });
    if (known != kept.end()) {
      cells.push_back(*known);
      continue;
    }
    const std::string title =
        "faults, " + std::to_string(cells.size() + 1) + " of " + std::to_string(plans.size()) + ", " + plan.row->name;
    auto cell = run_cell(robot, {o.robot_path, o.out, o.slow, o.most_repeats, o.world}, plan, title, pauses);
    if (!cell) {
      break;
    }
    tell_and_keep(plan, cell.value(), o.out);
    if (cell.value().holds()) {
      if (auto appended = faults::append_cell(kept_path, origin, cell.value()); !appended) {
        ran.not_kept = appended.error().message;
      }
    }
    cells.push_back(std::move(cell).value());
    static_cast<void>(report::write_json(o.json_path, outcome_of(robot, ran, plans.size())));  // the last is checked
  }
  return ran;
}

/// The cells that the options ask for. Refuses rows that there are not, and a draw of more cells than there are.
Result<std::vector<faults::CellPlan>> plans_of(const FaultsOptions& o, const robot::Robot& robot) {
  const bool has_supply = o.world == participant::World::kBody && robot.supply;
  const faults::Where place = !participant::is_on_ground(o.world) ? faults::Where::kBench
                              : has_supply                        ? faults::Where::kSupply
                                                                  : faults::Where::kGround;
  const auto rows = FARRIER_TRY(faults::chosen_rows(o.rows, place));
  std::vector<faults::CellPlan> all = faults::plan_cells(rows, o.vendors, o.seeds);
  const auto count = static_cast<std::size_t>(o.cells);
  if (count > all.size()) {
    return Error{"--cells: these rows, vendors and seeds have " + std::to_string(all.size()) +
                 " cells: ask for no more, or for more --seeds"};
  }
  return count == 0 ? all : faults::draw_cells(all, count, o.seed);
}

int run_faults(FaultsOptions o) {
  participant::ProcessOptions file;
  file.robot_path = o.robot_path;
  file.world = o.world;
  file.no_dither = true;
  const auto robot = process::load_robot(file);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  if (participant::is_on_ground(o.world) && !robot.value().can_walk()) {
    return refuse("faults", "--world body: " + robot.value().cannot_walk_error());
  }
  const auto plans = plans_of(o, robot.value());
  if (!plans) {
    return refuse("faults", plans.error().message);
  }
  const auto directory = OutputDirectory::claim(o.out);
  if (!directory) {
    return refuse("faults", directory.error().message);
  }
  o.out = fs::absolute(o.out).lexically_normal().string();
  o.json_path = o.json_path.empty() ? o.out + "/figures.json" : o.json_path;
  if (auto way = make_way({o.json_path, o.page_path}, {o.robot_path}); !way) {
    return refuse("faults", way.error().message);
  }
  const std::size_t planned = plans.value().size();
  const Ran ran = run_all(robot.value(), o, plans.value());
  const report::Outcome outcome = outcome_of(robot.value(), ran, planned);
  std::fputs(report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str(), stdout);
  if (auto written = report::write_json(o.json_path, outcome); !written) {
    return fail("faults", written.error().message);
  }
  if (!o.page_path.empty()) {
    const bool on_ground = participant::is_on_ground(o.world);
    const faults::PageFacts facts{planned, o.slow, o.cells > 0 ? std::optional(o.seed) : std::nullopt};
    const std::string page = on_ground ? faults::ground_page_markdown(ran.cells, facts, robot.value().name)
                                       : faults::fault_page_markdown(ran.cells, facts);
    if (auto written = replace_file(o.page_path, page); !written) {
      return fail("faults", written.error().message);
    }
  }
  std::printf("figures: %s\n", o.json_path.c_str());
  if (participant::stop_requested()) {
    return fail("faults",
                "interrupted; what there is of the table is written; the same with --continue goes on from here");
  }
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace

std::function<int()> declare_faults(CLI::App& app) {
  auto o = std::make_shared<FaultsOptions>();
  app.add_option("--robot", o->robot_path, "robot file")->type_name("<file>")->default_str("hyq.yaml, as shipped");
  app.add_option("--rows", o->rows, "rows of docs/faults.md; all unless told")->delimiter(',')->type_name("<name>,...");
  app.add_option("--dds", o->vendors, "vendors, of cyclone, fast and mixed")
      ->delimiter(',')
      ->check(CLI::IsMember(fault_vendors()))
      ->type_name("<vendor>,...")
      ->default_str("cyclone,fast");
  app.add_option("--seeds", o->seeds, "seeds, from 1 on")
      ->check(CLI::Range(1, 1000))
      ->type_name("<n>")
      ->capture_default_str();
  app.add_option("--cells", o->cells,
                 "cells to be drawn by chance, each row once before a row comes twice; all unless told")
      ->check(CLI::Range(1, 1000000))
      ->type_name("<n>");
  app.add_option("--seed", o->seed, "seed of the draw of --cells")->type_name("<n>")->capture_default_str();
  app.add_option("--slow", o->slow,
                 "slow motion: the clock goes slower than the machine's by this factor, and where a process starts by "
                 "three times it")
      ->check(CLI::Range(1, 100))
      ->type_name("<factor>")
      ->capture_default_str();
  app.add_option("--repeats", o->most_repeats,
                 "most repetitions of a cell that did not hold while the computer was paused")
      ->check(CLI::Range(0, 1000))
      ->type_name("<n>")
      ->capture_default_str();
  add_choice(app, "--world", o->world, participant::kWorlds,
             "what is hit: each joint on its bench, or the body of a robot that walks on a ground")
      ->default_str("bench");
  app.add_option("--out", o->out,
                 "directory of logs, the last trace, and traces of cells that did not hold or in which the robot fell")
      ->type_name("<dir>")
      ->capture_default_str();
  app.add_option("--json", o->json_path, "figures; figures.json in --out unless told")->type_name("<file>");
  app.add_option("--page", o->page_path,
                 "writes the table with what was measured, as docs/results/faults.md; with --world body its part about "
                 "a ground")
      ->type_name("<file>");
  app.add_flag("--continue", o->go_on,
               "runs the cells that did not hold or were not reached; those that held in an earlier run of the same "
               "build into --out are taken from there");
  return [o] { return run_faults(*o); };
}

}  // namespace farrier::cli
