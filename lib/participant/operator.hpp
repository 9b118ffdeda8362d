#pragma once

#include <algorithm>
#include <optional>

#include "participant/participant.hpp"

namespace farrier::participant {

/// An operator of a run: it takes no part in it, and may come and go.
inline Identity operator_of(const std::string& robot, std::uint64_t session = 0) {
  return {.name = "operator", .robot = robot, .session = session, .clock = bus::ClockKind::kRealtime};
}

/// A request of an operator for another mode, repeated until the supervisor answers with a mode that is newer than those
/// before it.
class ModeRequest {
 public:
  static constexpr Nanoseconds kAskAgain = std::chrono::milliseconds(500);

  ModeRequest(std::uint64_t session, signals::Request request, Tick tick = 0) {
    request_.session = session;
    request_.tick = tick;
    request_.request = request;
  }

  /// Takes a mode that the supervisor has published.
  void take(const signals::SystemMode& mode) noexcept {
    if (mode.session != request_.session || mode.epoch == 0) {
      return;
    }
    if (request_.count > 0 && before_ && mode.epoch > *before_) {
      answer_ = mode;
    }
    before_ = std::max(before_.value_or(0), mode.epoch);
  }

  /// The request to send now; none between two, before a mode is known, and after the answer. `heard`: the supervisor's
  /// reader is matched.
  std::optional<signals::SystemRequest> due(SteadyTime now, bool heard) noexcept {
    if (answer_ || !before_ || !heard || now < next_) {
      return std::nullopt;
    }
    next_ = now + kAskAgain;
    ++request_.count;
    return request_;
  }

  /// The mode by which the supervisor answered.
  const std::optional<signals::SystemMode>& answer() const noexcept { return answer_; }

 private:
  signals::SystemRequest request_;
  std::optional<std::uint32_t> before_;  ///< newest epoch before the answer
  std::optional<signals::SystemMode> answer_;
  SteadyTime next_{};
};

}  // namespace farrier::participant
