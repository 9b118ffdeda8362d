#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "core/time.hpp"
#include "run/run_listener.hpp"
#include "run/run_monitor.hpp"
#include "cli/processes/child_process.hpp"
#include "cli/processes/dds_run.hpp"

// A run that does not begin, or that makes no progress, ends after a limit.

namespace farrier::cli {

/// A limit to one wait. Time in which this process itself does not run does not count.
class WaitLimit {
 public:
  /// `limit_s`: in seconds; 0: the wait may last for ever.
  explicit WaitLimit(double limit_s) noexcept
      : limit_(std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(limit_s))) {}

  /// A wait begins.
  void begin(SteadyTime now) noexcept;
  /// True when the wait has reached the limit. While `held` says that a debugger is attached, the wait begins again;
  /// `held` is called ten times a second at most.
  bool reached(SteadyTime now, const std::function<bool()>& held);

 private:
  Nanoseconds limit_;
  Nanoseconds waited_{};
  SteadyTime looked_{};
};

/// The limits of a run: for its start, and in lock-step for each tick. The time is that of the computer's steady clock,
/// also in slow motion.
class RunLimits {
 public:
  /// `common`: the options of the processes of `run`, with the domain they are in. All outlive it.
  RunLimits(const DdsRun& run, const participant::ProcessOptions& common, const std::vector<run::Member>& members);

  /// Refuses when a limit is reached: with the processes that have not greeted and the reason, or with those that wait
  /// and their inputs. Call it repeatedly.
  Result<Done> check(const participant::Participant& launcher, const run::RunListener& listener,
                     const run::RunMonitor& monitor, const std::vector<ChildProcess>& children);

 private:
  std::string start_lacks(const participant::Participant& launcher, const std::vector<ChildProcess>& children) const;
  std::string tick_lacks(const run::RunListener& listener, const run::RunMonitor& monitor,
                         const std::vector<ChildProcess>& children) const;

  const DdsRun& run_;
  const participant::ProcessOptions& common_;
  const std::vector<run::Member>& members_;
  WaitLimit start_;
  WaitLimit tick_;
  Tick last_ = kNoTick;
};

}  // namespace farrier::cli
