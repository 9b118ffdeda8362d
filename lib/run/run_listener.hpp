#pragma once

#include <string>

#include "participant/participant.hpp"

namespace farrier::run {

/// The launcher's part in a run: it hears the clock and, in lock-step, is one of those whom the clock waits for, so that
/// nothing of a tick escapes who listens beside it.
class RunListener {
 public:
  /// `ticks` 0: until told to stop. `participant` outlives it.
  static Result<RunListener> create(participant::Participant& participant, Tick ticks);

  /// Takes what has come.
  void poll(SteadyTime now);

  /// Ticks that the clock has begun so far.
  Tick tick() const noexcept { return tick_; }

  /// For people.
  std::string waits_for() const;

 private:
  RunListener(participant::In<signals::ClockTick>& clock, participant::Participant& participant, Tick ticks) noexcept
      : clock_(clock), participant_(participant), ticks_(ticks) {}
  bool finished() const noexcept { return ticks_ > 0 && tick_ >= ticks_; }

  participant::In<signals::ClockTick>& clock_;
  participant::Participant& participant_;
  Tick ticks_;
  Tick tick_ = 0;         ///< next the clock must begin
  Tick begun_ = kNoTick;  ///< newest the clock has begun, which may be before the greeting is over here
  SteadyTime next_health_{};
};

}  // namespace farrier::run
