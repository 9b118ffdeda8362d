#pragma once

#include <sys/types.h>

#include <atomic>
#include <optional>
#include <thread>
#include <vector>

#include "core/time.hpp"
#include "report/figures/growth.hpp"

namespace farrier::cli {

using report::Growth;

/// Samples the resources of processes (/proc) a hundred times a run, at most every 5 s, on a thread without priority.
class GrowthWatch {
 public:
  /// Watches a run of this many ticks; a process 0 is left out. Without processes it does nothing.
  GrowthWatch(std::vector<pid_t> processes, Tick ticks);
  ~GrowthWatch();
  GrowthWatch(const GrowthWatch&) = delete;
  GrowthWatch& operator=(const GrowthWatch&) = delete;

  /// The run is at this tick.
  void tick(Tick now) noexcept { now_ = now; }

  /// Ends the watch and returns the growth by process, from the first look after a tenth of the run to the last one.
  /// A process that was left out or had ended by then has no value. Empty if there were fewer than two such looks.
  std::vector<std::optional<Growth>> growths();

 private:
  using Holdings = std::vector<std::optional<Growth>>;  ///< from nothing to what there is
  void look();
  void end();

  std::vector<pid_t> processes_;
  Tick ticks_;
  std::atomic<Tick> now_{0};
  std::atomic<bool> ends_{false};
  std::optional<Holdings> first_, last_;
  std::thread thread_;
};

}  // namespace farrier::cli
