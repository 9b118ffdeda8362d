#include "cli/trot/trot_options.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>

#include "runtime/processors.hpp"
#include "cli/base/help.hpp"
#include "cli/base/installation.hpp"

namespace farrier::cli {
namespace {

const std::map<std::string, DdsChoice> kDds = [] {
  std::map<std::string, DdsChoice> names;
  for (const DdsChoice choice : {DdsChoice::kCyclone, DdsChoice::kFast, DdsChoice::kMixed, DdsChoice::kInproc}) {
    names.emplace(to_string(choice), choice);
  }
  return names;
}();
const std::map<std::string, run::Grouping> kNodes{
    {"per-leg", run::Grouping::kPerLeg}, {"per-joint", run::Grouping::kPerJoint}, {"one", run::Grouping::kOne}};
constexpr double kLongestLimit_s = 86400.0;
constexpr int kProcessorsForLegs = 4;  ///< with fewer, joint_node processes wait for each other and for sim_bridge

}  // namespace

void declare_gait(CLI::App& app, TrotOptions& o) {
  o.robot_path = shipped_robot("hyq.yaml");
  app.add_option("--robot", o.robot_path, "robot file")->type_name("<file>")->default_str("hyq.yaml, as shipped");
  app.add_option("--duration", o.duration_s, "simulated seconds")
      ->check(between(0.1, 3600.0))
      ->type_name("<s>")
      ->capture_default_str();
  add_name(app, "--gait", o.gait, gait::kPatterns, "gait, instead of the robot file's");
  app.add_option("--frequency", o.frequency_Hz, "strides per second, instead of the robot file's")
      ->check(between(0.1, 10.0))
      ->type_name("<Hz>");
  app.add_option("--seed", o.seed, "seed of sensor noise and touchdown times")
      ->check(between(0.0, 18446744073709551615.0))
      ->type_name("<n>")
      ->capture_default_str();
  app.add_option("--out", o.out, "directory for the report, the trace and the logs")
      ->type_name("<dir>")
      ->capture_default_str();
  app.add_option("--json", o.json_path, "where the figures go")
      ->type_name("<file>")
      ->default_str("figures.json in --out");
}

void declare_processes(CLI::App& app, TrotOptions& o) {
  add_choice(app, "--dds", o.dds, kDds, "cyclone|fast|mixed|inproc",
             "DDS vendor; mixed: sim_bridge and estimator_service on Cyclone DDS, the rest on Fast DDS; inproc: all "
             "nodes in one process")
      ->envname("FARRIER_DDS")
      ->default_str("cyclone, or what FARRIER_DDS says");
  app.add_option(
         "--security", o.security,
         "folder of keys and permissions, as farrier security init makes it: processes prove who they are, write "
         "their own topics only, and encrypt")
      ->type_name("<dir>");
  add_choice(app, "--nodes", o.nodes, kNodes, "per-leg|per-joint|one", "joint_node processes")
      ->default_str("per-leg; one with --clock realtime on fewer than " + std::to_string(kProcessorsForLegs) +
                    " processors");
  app.add_option("--start-limit", o.start_limit_s,
                 "seconds within which every process must have greeted, else the run ends with status 1; 0: none")
      ->check(between(0.0, kLongestLimit_s))
      ->type_name("<s>")
      ->capture_default_str();
  app.add_option("--stall-limit", o.stall_limit_s,
                 "seconds within which the next tick must begin in lock-step, else the run ends with status 1; 0: none")
      ->check(between(0.0, kLongestLimit_s))
      ->type_name("<s>")
      ->capture_default_str();
}

void declare_control(CLI::App& app, TrotOptions& o) {
  add_choice(app, "--design", o.design, robot::kDesigns,
             "gains: adaptive begins with the swing design in both phases and redesigns from what it measures, "
             "probing the valves as the robot file says; stance and swing keep one design in both phases, phases "
             "keeps one for each; none of the three probes")
      ->default_str(
          "adaptive; phases with --clock realtime, with --world ideal, and where joints on a ground cannot adapt");
  app.add_option("--estimator", o.estimator, "section of the robot file's estimators that every joint uses")
      ->type_name("<name>");
  add_name(app, "--controller", o.controller, robot::kControllerKinds,
           "kind of every controller, instead of the robot file's");
}

void declare(CLI::App& app, TrotOptions& o) {
  declare_gait(app, o);
  declare_processes(app, o);
  declare_control(app, o);
  add_choice(app, "--clock", o.clock, kClockKinds, "lock-step, which repeats bit for bit, or real time")
      ->default_str("lockstep");
  add_choice(
      app, "--world", o.world, participant::kWorlds,
      "body: the whole robot on a ground, on its own actuators; ideal: there, its joints follow torques at once; "
      "bench: each joint on a load of its own that follows the gait")
      ->default_str("body if the robot file has body.trunk and locomotion, else bench");
  app.add_option("--scene", o.scene_path, "body: scene file of the ground, pushes and payloads; a plane unless given")
      ->type_name("<file>");
  app.add_option("--velocity", o.velocity, "body: velocity of the trot: forward, left (m/s), yaw rate (rad/s)")
      ->expected(3)
      ->delimiter(',')
      ->type_name("<x,y,yaw>")
      ->capture_default_str();
  app.add_option("--locomotion", o.locomotion, "program that runs in place of locomotion, as the how-to explains")
      ->type_name("<program>");
  app.add_flag("--no-locomotion", o.no_locomotion,
               "starts no locomotion: another process takes its part, such as farrier ros --joint-commands; real time "
               "only")
      ->type_name("");
  app.add_option("--trace", o.trace_path, "where the trace goes")
      ->type_name("<file>")
      ->default_str("trace.csv in --out");
  app.add_option("--record", o.record_path,
                 "records everything that crosses the bus, as farrier record does; in lock-step no sample is missing")
      ->type_name("<file>");
  app.add_flag("--security-cost", o.security_cost,
               "short runs with --security and without, in turns: figure trot.security.latency_p50_ratio")
      ->type_name("");
  app.add_flag("--dither-cost", o.dither_cost,
               "two more runs in process, each phase with its fixed design, with the dither of the robot file and "
               "without: figure trot.dither_cost_ratio")
      ->type_name("");
  app.add_flag("--no-comparison", o.no_comparison,
               "bench: none of the runs that this one is compared with, nor their figures: the swing design's, in real "
               "time those of a bare timer, of the bare exchange and in lock-step")
      ->type_name("");
  app.add_flag("--soak", o.soak,
               "watch memory, threads and descriptors of every process started, which must not grow after the first "
               "tenth of the "
               "run: figures trot.memory_growth_KiB, trot.threads_growth, trot.descriptors_growth")
      ->type_name("");
  app.add_flag("--standby", o.standby,
               "a second supervisor stands by and leads when the first falls silent; real time only")
      ->type_name("");
  app.add_flag("--print-config", o.print_config, "print the effective robot file and end")->type_name("");
}

run::Grouping grouping_of(const TrotOptions& o) {
  const bool crowded =
      o.clock == bus::ClockKind::kRealtime && std::ssize(runtime::own_processors()) < kProcessorsForLegs;
  return o.nodes.value_or(crowded ? run::Grouping::kOne : run::Grouping::kPerLeg);
}

}  // namespace farrier::cli
