#pragma once

#include "core/time.hpp"
#include "robot/robot.hpp"
#include "tools/monitor/display.hpp"
#include "tools/monitor/recent_events.hpp"

namespace farrier::display {

/// The table as text on standard output, once a second. Ends the monitor when nobody reads it any more.
class PlainText final : public Display {
 public:
  /// `robot` must outlive it.
  explicit PlainText(const robot::Robot& robot) : robot_(robot) {}

  void show(const monitor::Frame& frame) override;
  bool ended() const override { return ended_; }

 private:
  const robot::Robot& robot_;
  RecentEvents events_;
  SteadyTime next_{};
  bool ended_ = false;
};

/// Prints one table; false when nobody takes it.
bool print_table(const monitor::Frame& frame, const robot::Robot& robot, std::span<const monitor::EventFrame> events);

}  // namespace farrier::display
