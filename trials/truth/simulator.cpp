#include "trials/truth/simulator.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::truth {

Simulator::Simulator(const Machine& machine, const Clock& clock, std::uint64_t seed, const std::string& name)
    : machine_(machine),
      clock_(clock),
      force_noise_(seed, name, "truth random force"),
      dropout_noise_(seed, name, "truth dropout"),
      state_(at_rest(machine)) {
  acting_.command_A = machine_.bias_A;
  Vector ignored;
  outcome_ = differentiate(machine_, -clock_.lead_ticks * clock_.period_s, state_, acting_, ignored);
}

Reading Simulator::read() const {
  const Vector& x = state_;
  return {x[kX],
          machine_.velocity_lag_s > 0.0 ? x[kVelocityLag] : x[kV],
          (machine_.force_lag_s > 0.0 ? x[kForceLag] : outcome_.cell_force) + machine_.force_offset,
          x[kPa],
          x[kPb],
          outcome_.supply_Pa};
}

// A block of commands is lost now and then; the valve's electronics hold what they had.
double Simulator::taken(double command_A) {
  const auto tick = static_cast<Tick>(commands_.size());
  const Tick block = std::max<Tick>(1, std::llround(0.015 / clock_.period_s));
  const bool lost = machine_.dropout > 0.0 && dropout_noise_.uniform(tick / block) < machine_.dropout;
  return lost && !commands_.empty() ? commands_.back() : command_A;
}

// Ornstein and Uhlenbeck, exact from tick to tick.
void Simulator::draw_force() {
  if (machine_.random_force > 0.0) {
    const double kept = std::exp(-clock_.period_s / machine_.random_force_time_s);
    acting_.random_force = kept * acting_.random_force + std::sqrt(1.0 - kept * kept) * machine_.random_force *
                                                             force_noise_.normal(static_cast<Tick>(commands_.size()));
  }
}

void Simulator::tick(double command_A) {
  draw_force();
  commands_.push_back(taken(command_A));
  const int now = static_cast<int>(commands_.size()) - 1;
  const long late = std::lround(machine_.delay_s * clock_.substeps / clock_.period_s);
  const double h = clock_.period_s / clock_.substeps;
  const double start_s = (now - clock_.lead_ticks) * clock_.period_s;
  for (int j = 0; j < clock_.substeps; ++j) {
    const long asked = static_cast<long>(now) * clock_.substeps + j - late;
    const double command = asked < 0 ? 0.0 : commands_[static_cast<std::size_t>(asked / clock_.substeps)];
    play_A_ = std::clamp(play_A_, command - machine_.hysteresis_A, command + machine_.hysteresis_A);
    acting_.command_A = play_A_ + machine_.bias_A;
    advance(machine_, start_s + j * h, h, acting_, state_);
  }
  Vector ignored;
  outcome_ = differentiate(machine_, start_s + clock_.period_s, state_, acting_, ignored);
}

}  // namespace farrier::truth
