// farrier faults: every row of the table of faults made to happen to a trot of real processes, and judged.

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "gait/schedule.hpp"
#include "participant/loop.hpp"
#include "process/process.hpp"
#include "record/trace.hpp"
#include "robot/keys.hpp"
#include "tools/cli/command.hpp"
#include "tools/cli/dds_run.hpp"
#include "tools/cli/installation.hpp"
#include "tools/cli/output_file.hpp"
#include "tools/cli/pause_watch.hpp"
#include "tools/cli/trot_options.hpp"
#include "tools/cli/trot_run.hpp"
#include "tools/faults/fault_page.hpp"
#include "tools/report/console.hpp"
#include "tools/report/extended_model.hpp"
#include "tools/report/outcome.hpp"
#include "tools/report/run_info.hpp"

namespace farrier::cli {
namespace {

namespace fs = std::filesystem;

/// From a request's fault to the request, and from everything to the end of the run.
constexpr double kUntilArmed_s = 0.1;
constexpr double kAfterwards_s = 0.25;
/// Periods for which the computer may stand still in a cell, and how often one in which it did is run again.
constexpr double kMayPause_periods = 1.0;
constexpr int kMostRepeats = 10;

const std::vector<std::pair<std::string, DdsChoice>> kVendors{
    {"cyclone", DdsChoice::kCyclone}, {"fast", DdsChoice::kFast}, {"mixed", DdsChoice::kMixed}};

struct FaultsOptions {
  std::string robot_path = shipped_robot("hyq.yaml");
  std::vector<std::string> rows;
  std::vector<std::string> vendors{"cyclone", "fast"};
  int seeds = 3;
  int slow = 3;
  std::string out = "out/faults";
  std::string json_path, page_path;
};

int fail(const std::string& message, int status) {
  std::fprintf(stderr, "farrier faults: %s\n", message.c_str());
  return participant::stop_requested() ? participant::stop_status() : status;
}

/// The member that a row means: its own name, or the one that hosts the joint.
std::string member_of(const robot::Robot& robot, const std::vector<lab::Member>& members, const std::string& name) {
  const std::string& joint = faults::hit_joint(robot).name;
  for (const lab::Member& member : members) {
    const bool hosts = std::ranges::find(member.joints, joint) != member.joints.end();
    if (member.name == name || (name == "joint_node" && member.executable == name && hosts)) {
      return member.name;
    }
  }
  return name;
}

/// One run of a cell, judged. Refuses when the user interrupts.
Result<faults::Cell> run_cell_once(const robot::Robot& robot, const FaultsOptions& o, const faults::Row& row,
                                   gait::Phase phase, const std::pair<std::string, DdsChoice>& vendor,
                                   std::uint64_t seed, const std::string& title, PauseWatch& pauses) {
  const auto ticks = [&](double time_s) { return static_cast<Tick>(std::llround(time_s / robot.period_s)); };
  const faults::TickSpan span = faults::place_of(robot, gait::Schedule(robot.plan, seed), row, phase);
  faults::Cell cell{.row = row.name,
                    .phase = phase == gait::Phase::kStance ? "stance" : "swing",
                    .vendor = vendor.first,
                    .seed = seed,
                    .repeats = 0,
                    .error = {},
                    .checks = {}};
  TrotOptions trot;
  trot.robot_path = o.robot_path;
  trot.dds = vendor.second;
  trot.clock = bus::ClockKind::kRealtime;
  trot.design = "phases";
  trot.standby = row.standby;
  trot.seed = seed;
  trot.out = o.out;
  trot.trace_path = o.out + "/trace.csv";
  DdsRun run = dds_run(robot, trot, title);
  run.common.slow = o.slow;
  run.goes_on_without_the_dead = true;
  run.looks_on = [&](Tick tick) {
    if (tick < span.begin - faults::kBefore) {
      pauses.forget();
    }
  };
  const auto members = lab::plan_members(robot, run.grouping, run.standby);
  if (row.member != nullptr) {
    run.faults[member_of(robot, members, row.member)] = faults::arrow_faults(robot, row, span);
  }
  for (const faults::ProcessAct& act : row.acts) {
    run.acts.push_back({.at = span.begin + ticks(act.at_s), .member = member_of(robot, members, act.member),
                        .signal = act.signal});
  }
  if (row.expected.latches) {
    run.acts.push_back({.at = span.end + ticks(kUntilArmed_s), .member = {}});
  }
  const Tick last = run.acts.empty() ? span.end : std::max(span.end, run.acts.back().at);
  run.common.ticks = last + ticks(kAfterwards_s);
  const auto ran = run_over_dds(robot, run);
  if (participant::stop_requested()) {
    return Error{"interrupted"};
  }
  const auto trace = faults::leaves_trace(row) ? record::read_trace(run.common.trace_path, robot::joint_names(robot))
                                               : Result<std::vector<record::TraceRow>>(std::vector<record::TraceRow>{});
  if (!ran || !trace) {
    cell.error = !ran ? ran.error().message : trace.error().message;
    return cell;
  }
  const std::vector<Tick>& acted = ran.value().acted;
  if (acted.size() < run.acts.size()) {
    cell.error = "the run ended before all was done to it";
    return cell;
  }
  faults::Moments moments{span, last};
  if (!row.acts.empty()) {
    moments.fault.begin = acted.front();
    moments.fault.end = row.acts.size() > 1 ? acted[row.acts.size() - 1] : acted.front() + ticks(row.lasts_s);
  }
  if (row.expected.latches) {
    moments.armed = acted.back();
  }
  std::vector<faults::Heard> heard;
  for (std::size_t i = 0; i < ran.value().events.size(); ++i) {
    heard.push_back({std::string(signals::text_of(ran.value().events[i].text)), ran.value().events_heard[i]});
  }
  cell.checks = faults::judge(robot, row, moments, trace.value(), heard);
  return cell;
}

/// One cell, judged by a run in which the computer did not stand still, or by the last of several in which it did.
Result<faults::Cell> run_cell(const robot::Robot& robot, const FaultsOptions& o, const faults::Row& row,
                              gait::Phase phase, const std::pair<std::string, DdsChoice>& vendor, std::uint64_t seed,
                              const std::string& title, PauseWatch& pauses) {
  const double may_pause_s = kMayPause_periods * robot.period_s * o.slow;
  for (int repeats = 0;; ++repeats) {
    auto cell = run_cell_once(robot, o, row, phase, vendor, seed, title, pauses);
    if (!cell) {
      return cell.error();
    }
    const bool paused = std::chrono::duration<double>(pauses.longest()).count() > may_pause_s;
    if (!paused || cell.value().holds() || repeats == kMostRepeats) {
      cell.value().repeats = repeats;
      return cell;
    }
  }
}

std::string place_text(const faults::Cell& cell) {
  return cell.row + ", " + cell.phase + ", " + cell.vendor + ", seed " + std::to_string(cell.seed);
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
      outcome.failures.push_back(place_text(cell) + ": " + cell.error);
    }
  }
  outcome.figures.add("faults.cells", static_cast<double>(planned));
  outcome.figures.add("faults.repeats", repeats);
  outcome.figures.add("faults.held", static_cast<double>(std::ranges::count_if(cells, &faults::Cell::holds)),
                      static_cast<double>(planned));
  for (const faults::Row& row : faults::rows()) {
    for (const faults::Check& check : faults::worst_checks(cells, row.name)) {
      outcome.figures.add("faults." + std::string(row.name) + "." + check.key + "_ms", check.measured_s * 1e3,
                          check.asked_s * 1e3);
    }
  }
  return outcome;
}

std::vector<const faults::Row*> chosen_rows(const FaultsOptions& o) {
  std::vector<const faults::Row*> chosen;
  for (const faults::Row& row : faults::rows()) {
    if (o.rows.empty() || std::ranges::find(o.rows, row.name) != o.rows.end()) {
      chosen.push_back(&row);
    }
  }
  return chosen;
}

/// The cells of `rows`, or those until the user interrupts.
std::vector<faults::Cell> run_all(const robot::Robot& robot, const FaultsOptions& o,
                                  const std::vector<const faults::Row*>& rows, std::size_t planned) {
  std::vector<faults::Cell> cells;
  PauseWatch pauses;
  for (const faults::Row* row : rows) {
    for (const auto& vendor : kVendors) {
      for (const gait::Phase phase : {gait::Phase::kStance, gait::Phase::kSwing}) {
        for (int seed = 1; seed <= o.seeds && std::ranges::find(o.vendors, vendor.first) != o.vendors.end(); ++seed) {
          const std::string title = "faults, " + std::to_string(cells.size() + 1) + " of " + std::to_string(planned) +
                                    ", " + row->name;
          auto cell = run_cell(robot, o, *row, phase, vendor, static_cast<std::uint64_t>(seed), title, pauses);
          if (!cell) {
            return cells;
          }
          if (!cell.value().holds()) {
            std::fprintf(stderr, "%s: %s\n", place_text(cell.value()).c_str(), faults::why_not(cell.value()).c_str());
          }
          cells.push_back(std::move(cell).value());
        }
      }
    }
  }
  return cells;
}

int run_faults(FaultsOptions o) {
  for (const std::string& row : o.rows) {
    if (faults::find_row(row) == nullptr) {
      std::string names;
      for (const faults::Row& known : faults::rows()) {
        names += (names.empty() ? "" : ", ") + std::string(known.name);
      }
      return fail("--rows: no row is called '" + row + "': " + names, kBadInput);
    }
  }
  participant::ProcessOptions file;
  file.robot_path = o.robot_path;
  file.no_dither = true;
  const auto robot = process::load_robot(file);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  const auto directory = OutputDirectory::claim(o.out);
  if (!directory) {
    return fail(directory.error().message, kBadInput);
  }
  o.out = fs::absolute(o.out).lexically_normal().string();
  o.json_path = o.json_path.empty() ? o.out + "/figures.json" : o.json_path;
  if (auto way = make_way({o.json_path, o.page_path}, {o.robot_path}); !way) {
    return fail(way.error().message, kBadInput);
  }
  const std::vector<const faults::Row*> rows = chosen_rows(o);
  const std::size_t planned = rows.size() * 2 * o.vendors.size() * static_cast<std::size_t>(o.seeds);
  const std::vector<faults::Cell> cells = run_all(robot.value(), o, rows, planned);
  const report::Outcome outcome = outcome_of(robot.value(), cells, planned);
  if (auto written = report::write_json(o.json_path, outcome); !written) {
    return fail(written.error().message, kFailed);
  }
  if (!o.page_path.empty()) {
    if (auto written = report::replace_file(o.page_path, faults::fault_page_markdown(cells, planned)); !written) {
      return fail(written.error().message, kFailed);
    }
  }
  std::fputs(report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str(), stdout);
  std::printf("figures: %s\n", o.json_path.c_str());
  if (participant::stop_requested()) {
    return fail("interrupted; what there is of the table is written", kFailed);
  }
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace

std::function<int()> declare_faults(CLI::App& app) {
  auto o = std::make_shared<FaultsOptions>();
  app.add_option("--robot", o->robot_path, "robot file")->type_name("<file>")->capture_default_str();
  app.add_option("--rows", o->rows, "rows of docs/faults.md; all unless told")->delimiter(',')->type_name("<name>,...");
  app.add_option("--dds", o->vendors, "vendors, of cyclone, fast and mixed")
      ->delimiter(',')
      ->check(CLI::IsMember({"cyclone", "fast", "mixed"}))
      ->type_name("<vendor>,...")
      ->default_str("cyclone,fast");
  app.add_option("--seeds", o->seeds, "seeds, from 1 on")
      ->check(CLI::Range(1, 1000))
      ->type_name("<n>")
      ->capture_default_str();
  app.add_option("--slow", o->slow, "slow motion: the clock goes slower than the machine's by this factor")
      ->check(CLI::Range(1, 100))
      ->type_name("<factor>")
      ->capture_default_str();
  app.add_option("--out", o->out, "directory of logs and the last trace")->type_name("<dir>")->capture_default_str();
  app.add_option("--json", o->json_path, "figures; figures.json in --out unless told")->type_name("<file>");
  app.add_option("--page", o->page_path, "writes the table with what was measured, as docs/faults.md")
      ->type_name("<file>");
  return [o] { return run_faults(*o); };
}

}  // namespace farrier::cli
