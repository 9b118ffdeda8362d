#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/playback/recorded_run.hpp"

namespace farrier::playback {

/// The first field of an estimate that came out otherwise.
struct Difference {
  Tick tick = kNoTick;
  std::string field;  ///< name in idl/, with the place in an array: "a[4]"
  double recorded = 0.0, now = 0.0;
};

/// Today's estimates of one joint beside the recorded ones.
struct RerunJoint {
  std::uint64_t measurements = 0;  ///< fed
  std::uint64_t missing = 0;       ///< ticks without a measurement, between the first and the last
  std::uint64_t compared = 0;      ///< estimates of which both there are
  std::uint64_t different = 0;     ///< of those: in any bit
  std::uint64_t unanswered = 0;    ///< recorded estimates of ticks without a measurement
  std::uint64_t unrecorded = 0;    ///< estimates that the recording lacks
  std::optional<Difference> first;
};

struct Rerun {
  Tick first_tick = kNoTick;       ///< of all measurements; not 0: the recorded estimators had learnt before
  std::vector<RerunJoint> joints;  ///< by number
  std::string ending;              ///< RecordedRun::ending
};

/// Feeds the recorded measurements to the estimators of this version and compares what they say, bit by bit, with what
/// was recorded. Refuses estimator settings out of range, and when `keep_on` does.
Result<Rerun> rerun_estimator(RecordedRun& run, const KeepOn& keep_on = {});

}  // namespace farrier::playback
