#pragma once

#include <array>
#include <cstddef>

#include "control/law/force_controller.hpp"
#include "control/law/low_pass.hpp"

namespace farrier::control {

/// Low-passes that each signal of a joint has passed on its way: one for each channel, in this order.
struct ChannelCoefficients {
  FilterCoefficients position, velocity, force;
};

/// Makes filtered measurements fit for the estimation of a linear model: each signal passes the filters of the others,
/// so that all of them, the current included, have passed the same filters in the end. A linear relation between the
/// signals is then also one between the filtered signals. Channels with the same filter need not pass it twice.
/// Default: passes everything.
class SignalAligner {
 public:
  /// Input of an estimator at a tick.
  struct Signals {
    Measurement measured;
    double current_A;
  };

  SignalAligner() = default;
  /// `filters` of the channels; a default FilterCoefficients is none.
  explicit SignalAligner(const ChannelCoefficients& filters) noexcept {
    const std::array of{&filters.position, &filters.velocity, &filters.force};
    for (std::size_t i = 0; i < of.size(); ++i) {
      bool is_new = !(*of[i] == FilterCoefficients{});
      for (std::size_t earlier = 0; earlier < i; ++earlier) {
        is_new = is_new && !(*of[i] == *of[earlier]);
      }
      if (!is_new) {
        continue;
      }
      active_ = true;
      chains_[kCurrent][i] = LowPass(*of[i]);
      for (std::size_t channel = 0; channel < of.size(); ++channel) {
        chains_[channel][i] = *of[channel] == *of[i] ? LowPass() : LowPass(*of[i]);
      }
    }
  }

  /// Takes what was read at a tick, one tick after the last. The first counts as having been there always.
  Signals take(const Signals& read) noexcept {
    if (!active_) {
      return read;
    }
    const auto through = [this](std::size_t chain, double value) {
      for (LowPass& filter : chains_[chain]) {
        if (!settled_) {
          filter.settle(value);
        }
        value = filter.take(value);
      }
      return value;
    };
    const Signals aligned{
        {through(0, read.measured.position), through(1, read.measured.velocity), through(2, read.measured.force)},
        through(kCurrent, read.current_A)};
    settled_ = true;
    return aligned;
  }

  /// Forgets the past, as after a gap.
  void reset() noexcept { settled_ = false; }

 private:
  static constexpr std::size_t kCurrent = 3;

  bool active_ = false;
  bool settled_ = false;
  std::array<std::array<LowPass, 3>, 4> chains_;  // by signal, then by the channel whose filter it is
};

}  // namespace farrier::control
