#pragma once

#include <cstdint>
#include <optional>

#include "core/time.hpp"

namespace farrier::ros_bridge {

/// One sender has the robot until it is silent for a time. Messages count from their arrival.
class OneSender {
 public:
  explicit OneSender(Nanoseconds timeout) : timeout_(timeout) {}

  /// True if the newest message that was taken is older than the timeout, or none was.
  bool silent(SteadyTime now) const noexcept { return !heard_ || now - *heard_ > timeout_; }

  /// True if another sender has the robot.
  bool taken_by_another(std::uint64_t sender, SteadyTime now) const noexcept {
    return !silent(now) && sender != sender_;
  }

  /// A message of this sender was taken.
  void heard(std::uint64_t sender, SteadyTime now) noexcept {
    sender_ = sender;
    heard_ = now;
  }

  /// The place is free.
  void forget() noexcept { heard_.reset(); }

 private:
  Nanoseconds timeout_;
  std::uint64_t sender_ = 0;
  std::optional<SteadyTime> heard_;
};

/// End of a refusal of a message whose sender is a second one.
inline constexpr const char* kSecondSender = " of a second sender: the first one has the robot until it is silent";

}  // namespace farrier::ros_bridge
