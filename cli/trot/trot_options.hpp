#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/processes/dds_run.hpp"

namespace farrier::cli {

/// Runs of their own that `farrier trot` makes instead of one of the gait.
enum class Experiment { kNone, kLoadCycle, kSwitching, kUpdateLogic, kControllers };

/// What the command line of `farrier trot` says.
struct TrotOptions {
  std::string robot_path;
  DdsChoice dds = DdsChoice::kCyclone;
  bus::ClockKind clock = bus::ClockKind::kLockstep;
  std::string security;     ///< folder of keys and permissions for every process; empty: none
  std::optional<run::Grouping> nodes;  ///< as grouping_of says unless given
  std::string design;       ///< as supervisor::parse_design takes it; empty: adaptive, in real time phases
  double duration_s = 9.0;
  std::string gait;         ///< empty: the robot file's
  double frequency_Hz = 0;  ///< 0: the robot file's
  std::uint64_t seed = 1;
  std::string out = "out/trot";
  std::string trace_path;   ///< empty: trace.csv in `out`
  std::string json_path;    ///< empty: figures.json in `out`
  bool print_config = false;
  Experiment experiment = Experiment::kNone;
  std::string estimator;    ///< section of the robot file for every joint; empty: its own
  std::string controller;   ///< kind of every controller; empty: the robot file's
  bool security_cost = false;  ///< short runs with and without `security` beside
  bool dither_cost = false; ///< two more runs: what the robot file's dither costs
  bool vary = false;        ///< varied robots under every controller instead of one run
  bool soak = false;        ///< watch what processes grow by
  bool standby = false;     ///< a second supervisor stands by, real time only
  int seeds = 0;            ///< of `vary` and the controllers, from `seed` on; 0: not given, which is kSeeds; of `hide`
  std::optional<std::uint64_t> hide;  ///< of an effect of one simulated joint that nobody else knows
  std::string record_path;            ///< a recording of everything goes there; empty: none, with `hide` into `out`
};

inline constexpr int kSeeds = 5;

/// What a run that has no judged tick fails with.
inline constexpr const char* kTooShort =
    "too short to be judged, which begins with every leg's third stride: give a longer --duration";

void declare(CLI::App& app, TrotOptions& options);

/// The joint_node processes of a run: those asked for, else one per leg. In real time all joints are in one where the
/// computer has no processors for more (docs/decisions/0054-joint-nodes-and-processors.md).
run::Grouping grouping_of(const TrotOptions& options);

/// As --experiment takes it; empty: none.
std::string name_of(Experiment experiment);

}  // namespace farrier::cli
