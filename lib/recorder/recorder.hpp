#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bus/bus.hpp"
#include "participant/participant.hpp"
#include "robot/robot.hpp"
#include "recording/recording_file.hpp"

namespace farrier::recorder {

/// Counts of one topic's recorded samples.
struct TopicProgress {
  bus::TopicId topic{};
  std::uint64_t samples = 0;  ///< taken from the bus
  std::uint64_t lost = 0;     ///< missing in the sequence of its streams
  bus::ReaderStatus reader;   ///< what the transport says of it
};

/// A way of samples from the bus.
class Tap {
 public:
  virtual ~Tap() = default;
  /// Passes every waiting sample on, without probes of the greeting.
  virtual void drain(const recording::TakeSample& take) = 0;
  /// Appends the counts of each topic that comes this way.
  virtual void append_progress(std::vector<TopicProgress>& all) const = 0;
};

/// Reads topics of a robot's bus as a recording has them.
class Recorder {
 public:
  /// Adds readers that no writer waits for. `topics`: those to read; empty: all but journals. Refuses if the bus
  /// refuses.
  static Result<Recorder> create(bus::Bus& bus, const robot::Robot& robot, const std::vector<bus::TopicId>& topics);

  /// Reads every topic: streams by the journals of their writers (participant/stream_journal.hpp), which costs less
  /// than reading the streams themselves. Streams of a process without journals are not heard.
  static Result<Recorder> of_journals(bus::Bus& bus, const robot::Robot& robot);

  /// The same by ports of `participant`, which outlives it. In lock-step the run begins only when they hear every
  /// process.
  static Result<Recorder> of_journals(participant::Participant& participant, const robot::Robot& robot);

  /// Hands what has come on.
  void drain(const recording::TakeSample& take);

  std::vector<TopicProgress> progress() const;
  recording::TopicCounts lost() const;

 private:
  explicit Recorder(std::vector<std::unique_ptr<Tap>> taps) : taps_(std::move(taps)) {}

  std::vector<std::unique_ptr<Tap>> taps_;
};

}  // namespace farrier::recorder
