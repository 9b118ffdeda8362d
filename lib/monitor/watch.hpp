#pragma once

#include "monitor/robot_view.hpp"
#include "recorder/recorder.hpp"

namespace farrier::monitor {

/// Watches a running robot: reads the topics of its processes by readers that no writer waits for, and makes frames.
class Watch {
 public:
  /// `bus` and `robot` must outlive it. Refuses what the bus refuses.
  static Result<Watch> create(bus::Bus& bus, const robot::Robot& robot);

  /// Returns the frame of all samples until now. Samples known to be lost on the way, and writers with incompatible
  /// QoS, become its own events. Call it several times a second: a reader keeps the samples of five.
  Frame look();

 private:
  /// Counts already reported for a topic.
  struct Told {
    std::uint64_t lost = 0;
    std::uint64_t refused = 0;
    std::uint64_t time_ns = 0;
  };

  Watch(recorder::Recorder recorder, const robot::Robot& robot) : recorder_(std::move(recorder)), view_(robot) {}

  /// Notes new losses; returns the sum of all losses so far.
  std::uint64_t note_losses(std::uint64_t time_ns);

  recorder::Recorder recorder_;
  RobotView view_;
  std::array<Told, bus::kTopicCount> told_{};
};

}  // namespace farrier::monitor
