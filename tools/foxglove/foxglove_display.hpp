#pragma once

#include <memory>
#include <optional>
#include <string>

#include "bus/bus.hpp"
#include "recorder/polling.hpp"
#include "tools/foxglove/foxglove_server.hpp"
#include "tools/monitor/display.hpp"

namespace farrier::foxglove {

/// A running robot for viewers that speak Foxglove's protocol: the topics of RobotMessages.
class FoxgloveDisplay final : public display::Display {
 public:
  /// Time between calls of step().
  static constexpr std::chrono::milliseconds kStep{10};

  /// Opens the server. `robot` must outlive it. Refuses an address that cannot be had.
  static Result<std::unique_ptr<FoxgloveDisplay>> create(const display::ListenAddress& address,
                                                         const robot::Robot& robot);

  /// Reads the robot's sensors by polled readers that no writer waits for. `bus` must outlive it. Refuses what the bus
  /// refuses.
  Result<Done> join(bus::Bus& bus);

  void show(const monitor::Frame& frame) override;

  /// Sends what has come and is due.
  void step();

  /// "ws://127.0.0.1:8765"
  std::string url() const;
  /// A line about viewers and messages so far.
  std::string summary() const;

 private:
  FoxgloveDisplay(const robot::Robot& robot, ros_view::RobotMessages messages, display::ListenAddress address,
                  std::unique_ptr<FoxgloveServer> server)
      : robot_(robot), messages_(std::move(messages)), address_(std::move(address)), server_(std::move(server)) {}

  const robot::Robot& robot_;
  ros_view::RobotMessages messages_;
  display::ListenAddress address_;
  std::unique_ptr<FoxgloveServer> server_;
  std::optional<bus::Subscription<signals::JointSensors>> sensors_;
  std::optional<recorder::Newest<signals::BodyImu>> imu_;
  std::optional<recorder::Newest<signals::BodyState>> state_;
};

}  // namespace farrier::foxglove
