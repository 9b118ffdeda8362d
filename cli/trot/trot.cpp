// farrier trot: run, judge, report.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>

#include <unistd.h>

#include "gait/stepping.hpp"
#include "participant/loop.hpp"
#include "process/process.hpp"
#include "sim_bridge/simulated_robot.hpp"
#include "supervisor/joint_design.hpp"
#include "cli/base/command.hpp"
#include "cli/trot/body_run.hpp"
#include "cli/trot/in_process.hpp"
#include "cli/base/output_file.hpp"
#include "cli/trot/realtime.hpp"
#include "cli/trot/run_events.hpp"
#include "cli/trot/trot_options.hpp"
#include "cli/trot/trot_run.hpp"
#include "cli/trot/trot_security.hpp"
#include "report/trot/adaptation.hpp"
#include "report/figures/console.hpp"
#include "report/figures/text_format.hpp"
#include "report/trot/html_report.hpp"
#include "report/trot/joint_poles.hpp"
#include "report/trot/tracking.hpp"
#include "robot/derive.hpp"

namespace farrier::cli {
namespace {

namespace fs = std::filesystem;

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

/// Empty if a leg stands at every moment of the stride.
std::string flight_warning(const gait::RobotPlan& plan) {
  const double flight = gait::flight_share(plan);
  return flight > 0.0 ? "no leg stands in " + report::short_number(100.0 * flight) +
                            " % of the stride: see phase_offset of the legs and duty of the gait"
                      : "";
}

/// The remedy for options that do not go together; empty when they do.
std::string refusal(const robot::Robot& robot, const TrotOptions& o) {
  const bool realtime = o.clock == bus::ClockKind::kRealtime;
  if (participant::is_on_ground(o.world)) {
    if (std::string refused = refused_on_ground(robot, o); !refused.empty()) {
      return refused;
    }
  }
  if (o.standby && !realtime) {
    return "--standby is for the real-time clock, in lock-step a run waits for a silent supervisor: add --clock "
           "realtime";
  }
  if (o.soak && o.dds == DdsChoice::kInproc) {
    return "--soak watches the processes of one run over DDS: leave --dds inproc out";
  }
  if (o.no_locomotion && (!realtime || !o.locomotion.empty())) {
    return realtime
               ? "--no-locomotion starts none: leave --locomotion out"
               : "--no-locomotion is for the real-time clock, in lock-step a run waits for every command: add --clock "
                 "realtime";
  }
  if (!o.locomotion.empty()) {
    if (o.dds == DdsChoice::kInproc) {
      return "--locomotion starts a process: leave --dds inproc out";
    }
    if (!fs::is_regular_file(o.locomotion) || ::access(o.locomotion.c_str(), X_OK) != 0) {
      return "--locomotion: " + o.locomotion + " is not a program that can be started: build it, or correct the path";
    }
  }
  if (o.dds == DdsChoice::kInproc && realtime) {
    return "--dds inproc runs on the lock-step clock only: choose a vendor for --clock realtime";
  }
  return {};
}

/// The runs beside that the options ask for.
Result<Done> add_runs_beside(const robot::Robot& robot, const TrotOptions& o, report::Figures& figures) {
  if (o.dither_cost) {
    participant::ProcessOptions probed = common_options(o);
    probed.no_dither = false;
    const auto loaded = process::load_robot(probed);
    if (!loaded) {
      return Error{config::to_string(loaded.error())};
    }
    if (auto added = add_dither_cost(loaded.value(), o, figures); !added) {
      return added;
    }
  }
  if (o.security_cost) {
    if (auto added = add_security_cost(robot, o, figures); !added) {
      return added;
    }
  }
  return o.no_comparison ? Result<Done>(Done{}) : add_swing_design(robot, o, figures);
}

/// Robots that can walk on a ground do so unless --world says otherwise. A printed configuration is the file's own.
participant::World default_world(const TrotOptions& o) {
  if (o.print_config) {
    return participant::World::kBench;
  }
  const auto robot = robot::load_robot(o.robot_path);
  if (!robot || !robot.value().can_walk()) {
    return participant::World::kBench;
  }
  if (!sim_bridge::has_physics_engine()) {
    std::fputs("trot: this build has no physics engine (libmujoco-dev): the robot runs on the bench\n", stderr);
    return participant::World::kBench;
  }
  return participant::World::kBody;
}

/// With a tick of delay one design does not suit both loads, and nothing shows yet that adaptation gets by with it while it
/// learns. So in real time each slot has the design for its own load, and so have joints on a ground that cannot adapt.
robot::Design default_design(const TrotOptions& o) {
  if (o.clock == bus::ClockKind::kRealtime || o.world == participant::World::kIdeal) {
    return robot::Design::kPhases;
  }
  if (participant::is_on_ground(o.world)) {
    TrotOptions adaptive = o;
    adaptive.design = robot::Design::kAdaptive;
    const auto robot = process::load_robot(common_options(adaptive));
    if (robot && robot.value().can_walk() && !cannot_adapt_on_ground(robot.value()).empty()) {
      return robot::Design::kPhases;
    }
  }
  return robot::Design::kAdaptive;
}

int trot(TrotOptions o) {
  if (!o.design) {
    o.design = default_design(o);
  }
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
  if (participant::is_on_ground(o.world) && !robot.can_walk()) {
    std::fprintf(stderr, "trot: %s; it runs on the bench\n", robot.cannot_walk_error().c_str());
    o.world = participant::World::kBench;
  }
  const bool on_ground = participant::is_on_ground(o.world);
  if (const std::string refused = refusal(robot, o); !refused.empty()) {
    std::fprintf(stderr, "farrier trot: %s\n", refused.c_str());
    return kBadInput;
  }
  if (auto secured = check_security(robot, o); !secured) {
    std::fprintf(stderr, "farrier trot: %s\n", secured.error().message.c_str());
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
  if (auto way = make_way({o.trace_path, o.json_path, o.record_path}, {o.robot_path}); !way) {
    std::fprintf(stderr, "farrier trot: %s\n", way.error().message.c_str());
    return kBadInput;
  }
  if (const std::string note = robot::rigid_spring_note(robot.file); !note.empty()) {
    std::fprintf(stderr, "trot: note: %s\n", note.c_str());
  }
  if (on_ground) {
    return run_on_ground(robot, o);
  }
  if (const std::string order = gait::stepping_order(robot.plan); !order.empty()) {
    std::fprintf(stderr, "trot: legs step in the order %s\n", order.c_str());
  }
  const std::string flight = flight_warning(robot.plan);
  if (!flight.empty()) {
    std::fprintf(stderr, "trot: warning: %s\n", flight.c_str());
  }
  const bool lockstep = o.clock == bus::ClockKind::kLockstep;
  const bool compared_in_realtime = !lockstep && !o.no_comparison;
  Yardstick yardstick;
  if (compared_in_realtime) {
    auto measured = measure_yardstick(robot, o);
    if (!measured) {
      return fail("trot", measured.error().message);
    }
    yardstick = std::move(measured).value();
  }
  auto ran = run_once(robot, o, "trot");
  if (!ran) {
    return fail("trot", ran.error().message);
  }
  const int loop_delay = lockstep ? robot.loop_delay_lockstep : robot.loop_delay_realtime;
  report::Outcome outcome;
  outcome.command = "trot";
  outcome.run = report::run_info(robot, o.seed);
  outcome.run.processes = report::process_infos(ran.value().hellos, ran.value().healths);
  outcome.run.decisions = report::decision_infos(robot, ran.value().decisions);
  outcome.warnings = ran.value().warnings;
  if (!flight.empty()) {
    outcome.warnings.push_back(flight);
  }
  for (const signals::SystemEvent& event : ran.value().events) {
    if (event.severity == signals::Severity::kError) {
      outcome.failures.emplace_back(signals::text_of(event.text));
    }
  }
  auto tracking = tracking_of(robot, ran.value(), o.trace_path, o.seed, loop_delay);
  if (!tracking) {
    for (const std::string& failure : outcome.failures) {
      std::fprintf(stderr, "farrier trot: %s\n", failure.c_str());
    }
    return fail("trot", tracking.error().message);
  }
  report::add_tracking(outcome.figures, robot, tracking.value(),
                       lockstep ? report::Judgement::kLockstep : report::Judgement::kMeasuredOnly);
  report::add_updates(outcome.figures, robot, outcome.run.decisions, tracking.value().ticks,
                      lockstep && o.design == robot::Design::kAdaptive);
  if (auto added = report::add_spectral_radii(outcome.figures, robot, loop_delay); !added) {
    return fail("trot", added.error().message);
  }
  outcome.figures.add("trot.ticks_per_s", static_cast<double>(tracking.value().ticks) / ran.value().wall_s);
  if (o.soak) {
    for (std::size_t i = 0; i < ran.value().growths.size(); ++i) {
      outcome.run.processes[i].growth = ran.value().growths[i];
    }
    std::ranges::move(report::add_growth(outcome.figures, outcome.run.processes), std::back_inserter(outcome.failures));
  }
  report::add_transport(outcome.figures, outcome.run, lockstep);
  if (compared_in_realtime) {
    if (auto added = add_realtime(outcome, robot, o, yardstick, tracking.value()); !added) {
      return fail("trot", added.error().message);
    }
  }
  if (!report::long_enough(robot, tracking.value())) {
    outcome.failures.emplace_back(kTooShort);
  }
  write_events(o.out + "/events.txt", robot, ran.value(), outcome.run.decisions);
  if (auto beside = add_runs_beside(robot, o, outcome.figures); !beside) {
    return fail("trot", beside.error().message);
  }
  if (auto written = report::write_json(o.json_path, outcome); !written) {
    return fail("trot", written.error().message);
  }
  const gait::Schedule schedule(robot.plan, o.seed);
  auto page = report::write_report(o.out, {outcome, robot, schedule, ran.value().rows, loop_delay, ran.value().gains});
  if (!page) {
    return fail("trot", page.error().message);
  }
  std::fputs(report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str(), stdout);
  std::printf("report: %s\nfigures: %s\ntrace: %s\n", page.value().c_str(), o.json_path.c_str(), o.trace_path.c_str());
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace

std::function<int()> declare_trot(CLI::App& app) {
  auto options = std::make_shared<TrotOptions>();
  declare(app, *options);
  return [options, &app] {
    if (app.count("--world") == 0) {
      options->world = default_world(*options);
    }
    if (participant::is_on_ground(options->world) && app.count("--duration") == 0) {
      options->duration_s = kWalkDuration_s;
    }
    return trot(*options);
  };
}

}  // namespace farrier::cli
