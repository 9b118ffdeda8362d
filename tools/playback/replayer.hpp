#pragma once

#include <memory>
#include <vector>

#include "bus/bus.hpp"
#include "robot/robot.hpp"
#include "recording/recording_file.hpp"

namespace farrier::playback {

/// One topic's way from a recording to the bus.
class Line {
 public:
  virtual ~Line() = default;
  /// False for bytes that are no sample of the topic, and for one that the bus refuses.
  virtual bool publish(std::span<const std::uint8_t> cdr) = 0;
};

/// Publishes recorded samples as the processes of the robot did that wrote them: a replay is a bus.
class Replayer {
 public:
  /// `topics`: those to publish; empty: all. Refuses what the bus refuses.
  static Result<Replayer> create(bus::Bus& bus, const robot::Robot& robot, const std::vector<bus::TopicId>& topics);

  /// True when it went out; false for topics that are not replayed too.
  bool publish(const recording::Sample& sample);

 private:
  std::vector<std::unique_ptr<Line>> lines_;  ///< by topic; null: not replayed
};

}  // namespace farrier::playback
