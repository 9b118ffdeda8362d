#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robot/robot.hpp"
#include "signals/signals.hpp"
#include "report/figures/growth.hpp"

namespace farrier::report {

/// Samples of one topic at one process.
struct TopicCount {
  std::string topic;  ///< as on the bus, "joint/sensors"
  std::uint64_t sent = 0;
  std::uint64_t received = 0;
  std::uint64_t lost = 0;  ///< known to be lost on the way to this process
};

/// One process of a run, by its own last report.
struct ProcessInfo {
  std::string name;
  std::uint16_t number = 0;
  std::uint32_t pid = 0;
  std::string vendor;         ///< of its DDS
  std::uint64_t periods = 0;  ///< of its control loop; 0 where it has none
  std::uint64_t missed_periods = 0;
  std::array<double, 4> latency_s{};  ///< as signals::SystemHealth has them; 0 where not measured
  std::array<double, 4> wake_up_s{};
  std::vector<TopicCount> topics;  ///< those it sent, received or lost samples of
  std::optional<Growth> growth{};  ///< where it was watched
};

/// The supervisor's decision about one joint's gains.
struct DecisionInfo {
  std::string joint;
  signals::JointUpdateDecision decision;

  bool accepted() const noexcept { return decision.verdict == signals::UpdateVerdict::kAccepted; }
};

struct Machine {
  std::string cpu_model;
  int cores = 0;
  std::string kernel;  ///< name, release and version; says PREEMPT_RT where it is
  std::uint64_t memory_bytes = 0;
};

/// Facts needed to repeat a run.
struct RunInfo {
  std::string version;
  std::string git_revision;        ///< of the source at configure time; "unknown" outside a repository
  std::string configuration;       ///< effective, YAML; empty for a command without a robot
  std::string configuration_hash;  ///< 16 hexadecimal digits; empty likewise
  std::uint64_t seed = 0;
  Machine machine;
  std::vector<ProcessInfo> processes;
  std::vector<DecisionInfo> decisions;  ///< in the order in which they came
};

/// This build: version and revision, "0.1.0 (git 6ec0a32d...)".
std::string build_name();

/// This build on this machine, no robot and no processes.
RunInfo run_info(std::uint64_t seed);

/// The same with the robot's effective configuration.
RunInfo run_info(const robot::Robot& robot, std::uint64_t seed);

/// The decisions with their joints' names; those about joints the robot does not have are left out.
std::vector<DecisionInfo> decision_infos(const robot::Robot& robot,
                                         std::span<const signals::JointUpdateDecision> decisions);

/// Returns the facts that a process reported about itself.
ProcessInfo process_info(const signals::SystemHello& hello, const signals::SystemHealth& health);

/// The same for every participant; both arguments by number.
std::vector<ProcessInfo> process_infos(const std::vector<signals::SystemHello>& hellos,
                                       const std::vector<signals::SystemHealth>& healths);

/// Adds trot.packets.* and trot.lost_samples, which must be 0 where losses are judged (best effort on the real-time
/// clock may lose some), and trot.latency_* where a process measured it.
void add_transport(Figures& figures, const RunInfo& run, bool judge_losses);

/// Adds latencies and deadline misses of a run's control loops: <prefix>.latency_*, .wake_up_* and .missed_periods,
/// with the bound `missed_bound`.
void add_latencies(Figures& figures, const std::string& prefix, const std::vector<ProcessInfo>& processes,
                   std::optional<double> missed_bound = std::nullopt);

}  // namespace farrier::report
