#pragma once

#include <memory>

#include "core/result.hpp"
#include "robot/robot.hpp"
#include "tools/monitor/display.hpp"

namespace farrier::display {

/// The table on the terminal that is standard input and output, with keys. The terminal is again what it was when this
/// object goes. One at a time.
class Terminal final : public Display {
 public:
  /// Refuses where these are no terminal, or one of which nothing is known. `robot` must outlive it.
  static Result<std::unique_ptr<Terminal>> create(const robot::Robot& robot);
  ~Terminal() override;
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Draws a few times a second, and at once after a key.
  void show(const monitor::Frame& frame) override;
  bool ended() const override;

 private:
  struct Screen;

  explicit Terminal(std::unique_ptr<Screen> screen);

  std::unique_ptr<Screen> screen_;
};

}  // namespace farrier::display
