#pragma once

#include "monitor/robot_view.hpp"
#include "recorder/recorder.hpp"

namespace farrier::monitor {

/// Watches a running robot: reads what its processes publish, by readers that no writer waits for, and makes frames.
class Watch {
 public:
  /// `bus` and `robot` must outlive it. Refuses what the bus refuses.
  static Result<Watch> create(bus::Bus& bus, const robot::Robot& robot);

  /// What has come until now. What it knows to be lost on the way, and writers it cannot hear for their QoS, are events
  /// of its own. To be called several times a second: a reader keeps what comes in five.
  Frame look();

 private:
  /// What was said of a topic so far.
  struct Told {
    std::uint64_t lost = 0;
    std::uint64_t refused = 0;
    std::uint64_t time_ns = 0;
  };

  Watch(recorder::Recorder recorder, const robot::Robot& robot) : recorder_(std::move(recorder)), view_(robot) {}

  /// Notes what is new; returns all that was lost so far.
  std::uint64_t note_losses(std::uint64_t time_ns);

  recorder::Recorder recorder_;
  RobotView view_;
  std::array<Told, bus::kTopicCount> told_{};
};

}  // namespace farrier::monitor
