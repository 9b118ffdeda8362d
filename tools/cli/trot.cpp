// farrier trot: run, judge, report.

#include <cstdio>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "lab/inproc_run.hpp"
#include "participant/loop.hpp"
#include "process/process.hpp"
#include "robot/keys.hpp"
#include "supervisor/joint_design.hpp"
#include "tools/cli/command.hpp"
#include "tools/cli/experiment.hpp"
#include "tools/cli/output_file.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/trot_options.hpp"
#include "tools/cli/vary.hpp"
#include "tools/report/console.hpp"
#include "tools/report/html_report.hpp"
#include "tools/report/joint_poles.hpp"
#include "tools/report/tracking.hpp"

namespace farrier::cli {
namespace {

namespace fs = std::filesystem;

int fail(const Error& error) {
  std::fprintf(stderr, "farrier trot: %s\n", error.message.c_str());
  return participant::stop_requested() ? participant::stop_status() : kFailed;
}

participant::ProcessOptions common_options(const TrotOptions& o) {
  participant::ProcessOptions common;
  common.robot_path = o.robot_path;
  common.clock = o.clock;
  common.seed = o.seed;
  common.session = static_cast<std::uint64_t>(::getpid());
  common.trace_path = o.trace_path;
  common.gait = o.gait;
  common.frequency_Hz = o.frequency_Hz;
  return common;
}

Result<RunOutcome> run_inproc(const robot::Robot& robot, const TrotOptions& o, supervisor::Design design,
                              const std::string& trace_path, const std::string& title) {
  participant::install_signal_handlers();
  lab::InprocRun run;
  run.grouping = o.nodes;
  run.ticks = lab::ticks_of(o.duration_s, robot);
  run.seed = o.seed;
  run.design = design;
  run.trace_path = trace_path;
  Progress progress(title, run.ticks);
  run.progress = [&](Tick tick) {
    progress.update(tick);
    return !participant::stop_requested();
  };
  const SteadyTime begin = std::chrono::steady_clock::now();
  auto result = lab::run_inproc(robot, run);
  if (!result) {
    return result.error();
  }
  RunOutcome outcome;
  outcome.members = lab::plan_members(robot, o.nodes);
  outcome.hellos = std::move(result.value().hellos);
  outcome.healths = std::move(result.value().healths);
  outcome.events = std::move(result.value().events);
  outcome.decisions = std::move(result.value().decisions);
  outcome.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

Result<RunOutcome> run_once(const robot::Robot& robot, const TrotOptions& o) {
  if (o.dds == DdsChoice::kInproc) {
    return run_inproc(robot, o, supervisor::Design::kStance, o.trace_path, "trot");
  }
  DdsRun run;
  run.dds = o.dds;
  run.grouping = o.nodes;
  run.common = common_options(o);
  // With a tick of delay the stance design does not hold the swing load: in real time each slot has its own.
  run.common.design = o.clock == bus::ClockKind::kRealtime ? "phases" : "stance";
  run.common.ticks = lab::ticks_of(o.duration_s, robot);
  run.executables = build_directory();
  run.log_directory = o.out + "/log";
  run.title = "trot";
  return run_over_dds(robot, run);
}

Result<report::Tracking> tracking_of(const robot::Robot& robot, const std::string& trace_path, std::uint64_t seed,
                                     int loop_delay, std::vector<record::TraceRow>& rows) {
  auto read = record::read_trace(trace_path, robot::joint_names(robot));
  if (!read) {
    return read.error();
  }
  rows = std::move(read).value();
  return report::track(robot, gait::Schedule(robot.plan, seed), rows, loop_delay);
}

/// The same gait with the swing design in both slots. In process: lock-step traces do not depend on the transport.
Result<Done> add_swing_design(robot::Robot robot, const TrotOptions& o, report::Figures& figures) {
  for (robot::Joint& joint : robot.joints) {
    joint.kind = control::Kind::kLqr;
  }
  const std::string path = o.out + "/trace_swing_design.csv";
  auto run = run_inproc(robot, o, supervisor::Design::kSwing, path, "trot, swing design beside");
  if (!run) {
    return run.error();
  }
  std::vector<record::TraceRow> rows;
  auto tracking = tracking_of(robot, path, o.seed, robot.loop_delay_lockstep, rows);
  if (!tracking) {
    return tracking.error();
  }
  report::add_swing_design_tracking(figures, robot, tracking.value());
  return Done{};
}

/// Joints of the robot file no controller can be designed for, a line each; empty when there are none.
std::string undesignable(const robot::Robot& robot) {
  std::string lines;
  for (const robot::Joint& joint : robot.joints) {
    for (const plant::LoadParams& load : {joint.swing_load, joint.stance_load}) {
      for (const int delay : {robot.loop_delay_lockstep, robot.loop_delay_realtime}) {
        const auto gains = supervisor::design_joint(joint, load, robot.period_s, delay);
        if (!gains && lines.find(gains.error().message) == std::string::npos) {
          lines += robot.path + ": joints: " + gains.error().message + "\n";
        }
      }
    }
  }
  return lines;
}

/// What changed in the run, one line an event.
void write_events(const std::string& path, const robot::Robot& robot, const RunOutcome& run) {
  std::ofstream file(path);
  for (const signals::SystemEvent& event : run.events) {
    file << "tick " << event.tick << ' ' << signals::to_string(static_cast<signals::Severity>(event.severity)) << ' '
         << (event.participant < run.members.size() ? run.members[event.participant].name : "?");
    if (event.joint < robot.joints.size()) {
      file << ' ' << robot.joints[event.joint].name;
    }
    file << ": " << signals::text_of(event.text) << '\n';
  }
}

int trot(TrotOptions o) {
  const auto loaded = process::load_robot(common_options(o));
  if (!loaded) {
    std::fputs(config::to_string(loaded.error()).c_str(), stderr);
    return kBadInput;
  }
  const robot::Robot& robot = loaded.value();
  if (o.print_config) {
    std::fputs(robot::print_config(robot).c_str(), stdout);
    return kPassed;
  }
  if (o.vary && o.clock == bus::ClockKind::kRealtime) {
    std::fputs("farrier trot: --vary runs on the lock-step clock only: leave --clock realtime out\n", stderr);
    return kBadInput;
  }
  if (o.dds == DdsChoice::kInproc && o.clock == bus::ClockKind::kRealtime) {
    std::fputs("farrier trot: --dds inproc runs on the lock-step clock only: choose a vendor for --clock realtime\n",
               stderr);
    return kBadInput;
  }
  const auto directory = OutputDirectory::claim(o.out);
  if (!directory) {
    std::fprintf(stderr, "farrier trot: %s\n", directory.error().message.c_str());
    return kBadInput;
  }
  o.out = fs::absolute(o.out).lexically_normal().string();
  o.trace_path = o.trace_path.empty() ? o.out + "/trace.csv" : fs::absolute(o.trace_path).string();
  if (const std::string missing = undesignable(robot); !missing.empty()) {
    std::fputs(missing.c_str(), stderr);
    return kBadInput;
  }
  o.json_path = o.json_path.empty() ? o.out + "/figures.json" : o.json_path;
  const std::string rows_path = o.vary ? o.out + "/vary.csv" : o.trace_path;
  for (const std::string& path : {rows_path, o.json_path}) {
    if (auto way = make_way(path); !way) {
      std::fprintf(stderr, "farrier trot: %s\n", way.error().message.c_str());
      return kBadInput;
    }
  }

  if (o.vary) {
    return vary(robot, o, rows_path);
  }
  if (o.experiment != Experiment::kNone) {
    return o.experiment == Experiment::kLoadCycle ? run_load_cycle(robot, o) : run_switching(robot, o);
  }
  auto ran = run_once(robot, o);
  if (!ran) {
    return fail(ran.error());
  }
  const bool lockstep = o.clock == bus::ClockKind::kLockstep;
  const int loop_delay = lockstep ? robot.loop_delay_lockstep : robot.loop_delay_realtime;
  report::Outcome outcome;
  outcome.command = "trot";
  outcome.run = report::run_info(robot, o.seed);
  for (std::size_t i = 0; i < ran.value().hellos.size(); ++i) {
    outcome.run.processes.push_back(report::process_info(ran.value().hellos[i], ran.value().healths[i]));
  }
  for (const signals::SystemEvent& event : ran.value().events) {
    if (event.severity == static_cast<std::uint8_t>(signals::Severity::kError)) {
      outcome.failures.emplace_back(signals::text_of(event.text));
    }
  }
  std::vector<record::TraceRow> rows;
  auto tracking = tracking_of(robot, o.trace_path, o.seed, loop_delay, rows);
  if (!tracking) {
    for (const std::string& failure : outcome.failures) {
      std::fprintf(stderr, "farrier trot: %s\n", failure.c_str());
    }
    return fail(tracking.error());
  }
  report::add_tracking(outcome.figures, robot, tracking.value(),
                       lockstep ? report::Judgement::kLockstep : report::Judgement::kMeasuredOnly);
  if (auto added = report::add_spectral_radii(outcome.figures, robot, loop_delay); !added) {
    return fail(added.error());
  }
  outcome.figures.add("trot.ticks_per_s", static_cast<double>(tracking.value().ticks) / ran.value().wall_s);
  report::add_transport(outcome.figures, outcome.run, lockstep);
  if (!report::long_enough(robot, tracking.value())) {
    outcome.failures.emplace_back(kTooShort);
  }
  write_events(o.out + "/events.txt", robot, ran.value());
  if (auto beside = add_swing_design(robot, o, outcome.figures); !beside) {
    return fail(beside.error());
  }
  if (auto written = report::write_json(o.json_path, outcome); !written) {
    return fail(written.error());
  }
  const gait::Schedule schedule(robot.plan, o.seed);
  auto page = report::write_report(o.out, {outcome, robot, schedule, rows, loop_delay});
  if (!page) {
    return fail(page.error());
  }
  std::fputs(report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str(), stdout);
  std::printf("report: %s\nfigures: %s\ntrace: %s\n", page.value().c_str(), o.json_path.c_str(), o.trace_path.c_str());
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace

std::function<int()> declare_trot(CLI::App& app) {
  auto options = std::make_shared<TrotOptions>();
  declare(app, *options);
  return [options] { return trot(*options); };
}

}  // namespace farrier::cli
