#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bus/bus.hpp"
#include "robot/robot.hpp"
#include "run_file/background_writer.hpp"

namespace farrier::recorder {

/// What was recorded of one topic.
struct TopicProgress {
  bus::TopicId topic{};
  std::uint64_t samples = 0;  ///< taken from the bus
  std::uint64_t lost = 0;     ///< that never came, by the sequence of its streams
};

/// One topic's way from the bus to the file.
class Tap {
 public:
  virtual ~Tap() = default;
  /// Hands every waiting sample on. Probes of the greeting, which nobody acts on, are left out.
  virtual void drain(run_file::BackgroundWriter& file) = 0;
  virtual TopicProgress progress() const = 0;
};

/// Reads topics of a robot's bus into a run file. Adds readers that no writer waits for.
class Recorder {
 public:
  /// `topics`: those to record; empty: all. Refuses what the bus refuses.
  static Result<Recorder> create(bus::Bus& bus, const robot::Robot& robot, const std::vector<bus::TopicId>& topics);

  /// Hands what has come to the file.
  void drain(run_file::BackgroundWriter& file);

  std::vector<TopicProgress> progress() const;
  run_file::TopicCounts lost() const;

 private:
  explicit Recorder(std::vector<std::unique_ptr<Tap>> taps) : taps_(std::move(taps)) {}

  std::vector<std::unique_ptr<Tap>> taps_;
};

}  // namespace farrier::recorder
