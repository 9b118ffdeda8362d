#pragma once

#include <optional>
#include <string>

#include "cli/base/command.hpp"
#include "cli/processes/dds_run.hpp"

namespace farrier::cli {

/// One run of a robot's gait, as the command line of `farrier trot` says. `compare` and `trial` make such runs, too.
struct TrotOptions {
  std::string robot_path;
  DdsChoice dds = DdsChoice::kCyclone;
  bus::ClockKind clock = bus::ClockKind::kLockstep;
  std::string security;                           ///< folder of keys and permissions for every process; empty: none
  double start_limit_s = DdsRun{}.start_limit_s;  ///< as DdsRun has it
  double stall_limit_s = DdsRun{}.stall_limit_s;  ///< as DdsRun has it
  std::optional<run::Grouping> nodes;             ///< as grouping_of says unless given
  std::optional<robot::Design> design;            ///< adaptive unless given, in real time phases
  participant::World world = participant::World::kBench;
  std::string scene_path;                       ///< of a body's ground; empty: a plane
  std::vector<double> velocity{0.4, 0.0, 0.0};  ///< of a body's trot: forward, left in m/s, yaw rate in rad/s
  std::string locomotion;      ///< program of the user's in place of locomotion; empty: the shipped one
  bool no_locomotion = false;  ///< no locomotion is started; another process takes its part
  double duration_s = 9.0;
  std::string gait;         ///< empty: the robot file's
  double frequency_Hz = 0;  ///< 0: the robot file's
  std::uint64_t seed = 1;
  std::string out = "out/trot";
  std::string trace_path;  ///< empty: trace.csv in `out`
  std::string json_path;   ///< empty: figures.json in `out`
  bool print_config = false;
  std::string estimator;       ///< section of the robot file for every joint; empty: its own
  std::string controller;      ///< kind of every controller; empty: the robot file's
  bool security_cost = false;  ///< short runs with and without `security` beside
  bool dither_cost = false;    ///< two more runs, for the cost of the robot file's dither
  bool soak = false;           ///< watch what processes grow by
  bool no_comparison = false;  ///< none of the runs that the figures of this one are compared with
  bool standby = false;        ///< a second supervisor stands by, real time only
  std::string record_path;     ///< a recording of everything goes there; empty: none
};

/// Error of a run without a judged tick.
inline constexpr const char* kTooShort =
    "too short to be judged, which begins with every leg's third stride: give a longer --duration";

/// --robot, --duration, --gait, --frequency, --seed, --out and --json.
void declare_gait(CLI::App& app, TrotOptions& options);

/// --dds, --nodes, --security, --start-limit and --stall-limit: how the processes of a run are started and watched.
void declare_processes(CLI::App& app, TrotOptions& options);

/// --design, --estimator and --controller.
void declare_control(CLI::App& app, TrotOptions& options);

/// All of these, and what `farrier trot` alone takes.
void declare(CLI::App& app, TrotOptions& options);

/// The joint_node processes of a run: those asked for, else one per leg. In real time all joints are in one where the
/// computer has no processors for more (docs/decisions/0054-joint-nodes-and-processors.md).
run::Grouping grouping_of(const TrotOptions& options);
}  // namespace farrier::cli
