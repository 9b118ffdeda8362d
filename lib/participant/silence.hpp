#pragma once

#include <optional>

#include "core/time.hpp"
#include "participant/event_registry.hpp"

namespace farrier::participant {

/// Detects that a stream has fallen silent, and that it is heard again. Before its first sample it is neither: the
/// greeting handles streams that have not begun.
class Silence {
 public:
  /// `after`: time without a sample that counts as silence. The kinds are the events of its begin and its end.
  Silence(Nanoseconds after, EventKind fell_silent, EventKind heard_again) noexcept
      : after_(after), fell_silent_(fell_silent), heard_again_(heard_again) {}

  /// A sample has come, at `at`.
  void heard(SteadyTime at) noexcept { heard_ = at; }

  /// Returns the event to report if the state has changed since the last call. Call it after samples were taken, so
  /// that samples that waited while this process was stopped count.
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
