#pragma once

#include <optional>

#include "core/time.hpp"
#include "participant/event_registry.hpp"

namespace farrier::participant {

/// Notices that a stream has fallen silent, and that it is heard again. Before its first sample it is neither: what has
/// not begun is the greeting's business.
class Silence {
 public:
  /// `after`: how long nothing comes before that counts as silence. The kinds: of the events that tell it and its end.
  Silence(Nanoseconds after, EventKind fell_silent, EventKind heard_again) noexcept
      : after_(after), fell_silent_(fell_silent), heard_again_(heard_again) {}

  /// A sample has come, at `at`.
  void heard(SteadyTime at) noexcept { heard_ = at; }

  /// The event to tell, when something has changed since the last look. Call it after samples were taken, so that what
  /// waited while this process stood still is not missed.
  std::optional<EventKind> look(SteadyTime now) noexcept {
    const bool silent = heard_ != SteadyTime{} && now - heard_ > after_;
    if (silent == silent_) {
      return std::nullopt;
    }
    silent_ = silent;
    return silent ? fell_silent_ : heard_again_;
  }

 private:
  Nanoseconds after_;
  EventKind fell_silent_, heard_again_;
  SteadyTime heard_{};
  bool silent_ = false;
};

}  // namespace farrier::participant
