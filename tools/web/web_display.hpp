#pragma once

#include "robot/robot.hpp"
#include "tools/monitor/display.hpp"
#include "tools/web/web_server.hpp"

namespace farrier::web {

/// Shows frames of a running robot to the pages of a server of its own.
class WebDisplay final : public display::Display {
 public:
  /// Refuses an address that cannot be had.
  static Result<std::unique_ptr<WebDisplay>> create(const display::ListenAddress& address, PageFiles page,
                                                    const robot::Robot& robot);
  void show(const monitor::Frame& frame) override;

  std::string url() const { return server_->url(); }
  int port() const noexcept { return server_->port(); }

 private:
  WebDisplay(std::shared_ptr<FrameRing> frames, std::unique_ptr<WebServer> server)
      : frames_(std::move(frames)), server_(std::move(server)) {}

  std::shared_ptr<FrameRing> frames_;
  std::unique_ptr<WebServer> server_;
};

}  // namespace farrier::web
