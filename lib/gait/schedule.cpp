#include "gait/schedule.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::gait {

PhaseTicks phase_ticks(const RobotPlan& plan) noexcept {
  const GaitParams& gait = plan.gait;
  const Tick stride = std::llround(1.0 / (gait.frequency_Hz * plan.period_s));
  return {.stride = stride,
          .stance = std::llround(gait.duty * static_cast<double>(stride)),
          .lead_in = std::llround(gait.lead_in_s / plan.period_s),
          .jitter = std::llround(gait.touchdown_jitter_s / plan.period_s)};
}

Schedule::Schedule(const RobotPlan& plan, std::uint64_t seed) : always_stand_(plan.gait.pattern == Pattern::kStand) {
  const Result<Done> valid = validate(plan);
  FARRIER_ENSURE(valid.ok(), "a schedule needs a valid plan: call validate() first");
  const PhaseTicks ticks = phase_ticks(plan);
  stride_ = ticks.stride;
  stance_ = ticks.stance;
  lead_in_ = ticks.lead_in;
  jitter_ = ticks.jitter;
  announce_ = plan.gait.announce_ticks;

  std::vector<Tick> offsets;
  for (const LegPlan& leg : plan.legs) {
    offsets.push_back(std::llround(leg.phase_offset * static_cast<double>(stride_)));
  }
  const Tick largest = *std::max_element(offsets.begin(), offsets.end());
  for (std::size_t i = 0; i < plan.legs.size(); ++i) {
    // at the end of the lead-in the leg that is furthest ahead is half way through its stance
    const Tick ahead = stance_ / 2 + offsets[i] - largest;
    legs_.push_back({lead_in_ - ahead, NoiseStream(seed, plan.legs[i].name, "touchdown")});
  }
}

Tick Schedule::since_origin(int leg, Tick tick) const noexcept { return std::max<Tick>(tick, 0) - legs_[leg].origin; }

Tick Schedule::ticks_since_touchdown(int leg, Tick tick) const noexcept {
  const Tick since = since_origin(leg, tick);
  return standing(since) ? since : since % stride_;
}

Phase Schedule::phase(int leg, Tick tick) const noexcept {
  return always_stand_ || ticks_since_touchdown(leg, tick) < stance_ ? Phase::kStance : Phase::kSwing;
}

double Schedule::standing_progress(int leg, Tick tick) const noexcept {
  if (tick < lead_in_) {
    return 0.5 * static_cast<double>(std::max<Tick>(tick, 0)) / static_cast<double>(lead_in_);
  }
  if (always_stand_) {
    return 0.5;
  }
  return std::max(0.5, static_cast<double>(since_origin(leg, tick)) / static_cast<double>(stance_));
}

double Schedule::stance_progress(int leg, Tick tick) const noexcept {
  if (standing(since_origin(leg, tick))) {
    return standing_progress(leg, tick);
  }
  const Tick since = ticks_since_touchdown(leg, tick);
  return since < stance_ ? static_cast<double>(since) / static_cast<double>(stance_) : -1.0;
}

double Schedule::swing_progress(int leg, Tick tick) const noexcept {
  if (phase(leg, tick) == Phase::kStance) {
    return -1.0;
  }
  return static_cast<double>(ticks_since_touchdown(leg, tick) - stance_) / static_cast<double>(stride_ - stance_);
}

double Schedule::actual_stance_progress(int leg, Tick tick) const noexcept {
  const Tick since = since_origin(leg, tick);
  if (standing(since)) {
    return standing_progress(leg, tick);
  }
  // the touchdown of this stride or, late in swing, an early one of the next
  const bool planned_swing = since % stride_ >= stance_;
  const Tick number = since / stride_ + (planned_swing ? 1 : 0);
  const Tick shift = touchdown_shift(leg, number);
  const Tick into_stance = since - number * stride_ - shift;
  return into_stance < 0 ? -1.0 : static_cast<double>(into_stance) / static_cast<double>(stance_ - shift);
}

Phase Schedule::actual_phase(int leg, Tick tick) const noexcept {
  return actual_stance_progress(leg, tick) < 0.0 ? Phase::kSwing : Phase::kStance;
}

std::optional<PhaseSwitch> Schedule::announcement(int leg, Tick now) const noexcept {
  if (always_stand_ || now < 0) {
    return std::nullopt;
  }
  const Tick origin = legs_[leg].origin;
  const Tick since = now + announce_ - origin;
  if (now == 0 && since > stance_ && since < stride_) {
    return PhaseSwitch{1, origin + stance_, Phase::kSwing};  // too soon to be announced in time
  }
  if (since < stance_) {
    return std::nullopt;
  }
  const auto strides = static_cast<std::uint32_t>(since / stride_);
  if (since % stride_ == stance_) {
    return PhaseSwitch{2 * strides + 1, now + announce_, Phase::kSwing};
  }
  if (since % stride_ == 0) {
    return PhaseSwitch{2 * strides, now + announce_, Phase::kStance};
  }
  return std::nullopt;
}

Tick Schedule::touchdown_shift(int leg, std::int64_t stride) const noexcept {
  // uniform over the 2 J + 1 whole ticks of [-J, J]
  const auto choices = static_cast<double>(2 * jitter_ + 1);
  return static_cast<Tick>(choices * legs_[leg].jitter.uniform(2 * stride)) - jitter_;
}

Tick Schedule::actual_switch(int leg, const PhaseSwitch& planned) const noexcept {
  return planned.phase == Phase::kStance ? planned.tick + touchdown_shift(leg, planned.count / 2) : planned.tick;
}

int Schedule::stride(int leg, Tick tick) const noexcept {
  const Tick since = since_origin(leg, tick);
  return standing(since) ? -1 : static_cast<int>(since / stride_) - 1;
}

}  // namespace farrier::gait
