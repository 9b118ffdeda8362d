#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/noise.hpp"
#include "trials/truth/machine.hpp"

namespace farrier::truth {

/// Outputs of ideal sensors, without noise and digits, SI.
struct Reading {
  double position, velocity, force, pressure_a_Pa, pressure_b_Pa, supply_Pa;
};

/// Numbers and steps of ticks.
struct Clock {
  double period_s;
  int lead_ticks;  ///< run before recording begins, for things to settle
  int substeps;    ///< Runge-Kutta steps per tick; with a delay a multiple of kGrid

  /// Delays are whole parts of a period, this many in it: a command changes between steps whatever their number.
  static constexpr int kGrid = 50;
};

/// A machine from rest, a period at a time, its valve behind the input's delay and hysteresis.
class Simulator {
 public:
  /// `seed` and `name` address what is random in the machine itself.
  Simulator(const Machine& machine, const Clock& clock, std::uint64_t seed, const std::string& name);

  /// Sensors now, before the command of this tick acts.
  Reading read() const;

  /// Holds the command for a period.
  void tick(double command_A);

  const Vector& state() const noexcept { return state_; }
  double supply_flow() const noexcept { return outcome_.supply_flow; }

 private:
  double taken(double command_A);
  void draw_force();

  Machine machine_;
  Clock clock_;
  NoiseStream force_noise_, dropout_noise_;
  std::vector<double> commands_;
  Vector state_;
  Acting acting_{};
  double play_A_ = 0.0;
  Outcome outcome_{};
};

}  // namespace farrier::truth
