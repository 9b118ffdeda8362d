#pragma once

#include <string>
#include <vector>

#include "participant/clock.hpp"
#include "cli/processes/child_process.hpp"

// Processes that listen to a run and have no part in it: recorders and monitors.

namespace farrier::cli {

struct DdsRun;

struct Onlooker {
  std::string name;                    ///< of its log
  std::vector<std::string> arguments;  ///< of the farrier command, to which the run's robot, domain and vendor are added
  std::string listens;                 ///< text in its log when it is about to listen
  bool stands_still = false;           ///< stopped (SIGSTOP) when a fourth of the run is over
};

/// Use of the processor by one of them after the first quarter of the run.
struct OnlookerUse {
  double processor_share = 0.0;  ///< of one core, 0..; 0 where the run ended before
};

/// The recorders and monitors of one run. The destructor asks them to end, then ends them.
class Onlookers {
 public:
  /// Returns when all of them listen, so that a run which begins then is not slowed by their start.
  static Result<Onlookers> start(const DdsRun& run, int domain);

  /// The clock has come to `tick`.
  void look(Tick tick, SteadyTime now);

  /// Ends them and returns their use up to the last look, in the order of DdsRun's list. Refuses if one did not end
  /// well.
  Result<std::vector<OnlookerUse>> finish();

 private:
  struct Use {
    double begin_s = 0.0, end_s = 0.0;  ///< seconds of processor it has had
  };

  explicit Onlookers(Tick ticks) : ticks_(ticks) {}

  Tick ticks_;
  std::vector<ChildProcess> processes_;
  std::vector<bool> stands_still_;
  std::vector<Use> uses_;
  SteadyTime begin_{}, end_{};
};

}  // namespace farrier::cli
