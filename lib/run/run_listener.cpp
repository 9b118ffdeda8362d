#include "run/run_listener.hpp"

#include <algorithm>

namespace farrier::run {

using namespace std::chrono_literals;

Result<RunListener> RunListener::create(participant::Participant& participant, Tick ticks) {
  auto clock = FARRIER_TRY(participant.subscribe<signals::ClockTick>({0}));
  return RunListener(*clock, participant, ticks);
}

void RunListener::poll(SteadyTime now) {
  clock_.drain([&](const signals::ClockTick& clock) { begun_ = std::max(begun_, clock.tick); });
  if (!participant_.started(now) || finished()) {
    return;
  }
  const bool lockstep = participant_.identity().clock == bus::ClockKind::kLockstep;
  for (; tick_ <= begun_; ++tick_) {
    if (lockstep) {
      participant_.tick_done(tick_);
    }
  }
  if (finished() || (!lockstep && now >= next_health_)) {
    next_health_ = now + 100ms;
    participant_.report_health(tick_, finished());
  }
}

std::string RunListener::waits_for() const {
  const std::string lacking = participant_.greeting_lacks();
  return lacking.empty() ? "clock/tick " + std::to_string(tick_) : lacking;
}

}  // namespace farrier::run
