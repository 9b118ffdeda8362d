#pragma once

#include "core/time.hpp"
#include "plant/supply.hpp"
#include "signals/signals.hpp"

namespace farrier::sim_bridge {

/// Samples of a supply: its pressure, and its flows as means since the last sample.
class SupplyMeter {
 public:
  /// Samples of a supply at tick 0.
  SupplyMeter(const plant::Supply& supply, double period_s) noexcept;

  /// Takes the sample of a tick, later than the last one.
  void sample(const plant::Supply& supply, Tick tick) noexcept;
  const signals::SupplyState& state() const noexcept { return state_; }

 private:
  double period_s_;
  plant::SupplyAccount last_;
  signals::SupplyState state_;
};

}  // namespace farrier::sim_bridge
