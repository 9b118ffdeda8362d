#include "lab/run_listener.hpp"

#include <algorithm>

namespace farrier::lab {
namespace {

using namespace std::chrono_literals;

class ClockListener final : public RunListener {
 public:
  ClockListener(participant::In<signals::ClockTick>* clock, participant::Participant& participant, Tick ticks)
      : clock_(clock),
        participant_(participant),
        lockstep_(participant.identity().clock == bus::ClockKind::kLockstep),
        ticks_(ticks) {}

  void poll(SteadyTime now) override;
  bool finished() const override { return ticks_ > 0 && tick_ >= ticks_; }
  int missing() const override { return 1; }
  std::string waits_for() const override {
    const std::string lacking = participant_.greeting_lacks();
    return lacking.empty() ? "clock/tick " + std::to_string(tick_) : lacking;
  }
  Tick tick() const override { return tick_; }

 private:
  participant::In<signals::ClockTick>* clock_;
  participant::Participant& participant_;
  bool lockstep_;
  Tick ticks_;
  Tick tick_ = 0;         ///< next the clock must begin
  Tick begun_ = kNoTick;  ///< newest the clock has begun
  SteadyTime next_health_{};
};

void ClockListener::poll(SteadyTime now) {
  clock_->drain([&](const signals::ClockTick& clock) { begun_ = std::max(begun_, clock.tick); });
  if (!participant_.started(now) || finished()) {
    return;
  }
  for (; tick_ <= begun_; ++tick_) {
    if (lockstep_) {
      participant_.tick_done(tick_);
    }
  }
  if (finished() || (!lockstep_ && now >= next_health_)) {
    next_health_ = now + 100ms;
    participant_.report_health(tick_, finished());
  }
}

}  // namespace

Result<std::unique_ptr<RunListener>> RunListener::create(participant::Participant& participant, Tick ticks) {
  auto clock = participant.subscribe<signals::ClockTick>({0});
  if (!clock) {
    return clock.error();
  }
  return std::unique_ptr<RunListener>(std::make_unique<ClockListener>(clock.value(), participant, ticks));
}

}  // namespace farrier::lab
