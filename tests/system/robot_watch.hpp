#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "deployed_robot.hpp"
#include "run/run_monitor.hpp"
#include "participant/options.hpp"
#include "trace/trace.hpp"
#include "robot/robot.hpp"

namespace farrier::test {

/// A deployment in real time, in slow motion as farrier faults has it.
inline constexpr int kSlow = 3;
/// Ticks after which the robot is armed and stands.
inline constexpr Tick kStanding = 500;
inline constexpr std::chrono::seconds kPatience{60};  ///< for what is some seconds of the robot's
inline DeployedRun slow_run(const std::string& dds) {
  return {.dds = dds, .clock = bus::ClockKind::kRealtime, .slow = kSlow};
}

/// Ends the processes. The trace of sim_bridge, or why it cannot be judged.
Result<std::vector<trace::TraceRow>> trace_after(DeployedProcesses& processes, const robot::Robot& robot);

/// Hears the clock and the events of a running robot. To be made on the host of the process whose options it gets.
class RobotWatch {
 public:
  RobotWatch(const robot::Robot& robot, const participant::ProcessOptions& seat);
  ~RobotWatch();

  /// Hears until the clock has begun `tick`. Returns the newest tick that it has, kNoTick if none. Less than `tick`
  /// means that the clock is stopped.
  Tick until(Tick tick, std::chrono::seconds budget);
  /// The newest that the clock has begun.
  Tick now();
  /// Asks the supervisor to arm, as an operator does.
  void arm();
  const run::RunMonitor& monitor() const noexcept { return *monitor_; }

 private:
  std::unique_ptr<bus::Bus> bus_;
  std::optional<bus::Subscription<signals::ClockTick>> clock_;
  std::optional<bus::Publisher<signals::SystemRequest>> requests_;
  std::optional<run::RunMonitor> monitor_;
  signals::SystemRequest request_;
  Tick newest_ = kNoTick;
};

/// States of the joints of some legs, by the trace of sim_bridge.
class JointCourse {
 public:
  JointCourse(const robot::Robot& robot, const std::vector<trace::TraceRow>& trace, std::vector<std::string> legs);

  /// The first tick from `begin` on at which all of them are `as`; nothing when there is none before `end`.
  template <class As>
  std::optional<Tick> first(As&& as, Tick begin, Tick end) const {
    for (Tick tick = begin; tick < std::min(end, end_); ++tick) {
      if (count(as, tick, tick + 1) == joints_.size()) {
        return tick;
      }
    }
    return std::nullopt;
  }
  /// Rows of them in [begin, end) that are `as`.
  template <class As>
  std::size_t count(As&& as, Tick begin, Tick end) const {
    std::size_t found = 0;
    for (Tick tick = begin; tick < std::min(end, end_); ++tick) {
      for (const std::size_t joint : joints_) {
        found += as(rows_[joint][static_cast<std::size_t>(tick)]) ? 1 : 0;
      }
    }
    return found;
  }
  std::size_t joints() const noexcept { return joints_.size(); }
  Tick end() const noexcept { return end_; }

 private:
  std::vector<std::size_t> joints_;
  std::vector<std::vector<trace::TraceRow>> rows_;  ///< by joint and tick
  Tick end_ = 0;
};

bool is_null(const trace::TraceRow& row);
bool is_tracking(const trace::TraceRow& row);
bool is_silent(const trace::TraceRow& row);  ///< sim_bridge hears no valve command of it
bool has_tripped(const trace::TraceRow& row);

}  // namespace farrier::test
