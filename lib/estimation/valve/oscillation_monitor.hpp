#pragma once

#include <cmath>

namespace farrier::estimation {

/// Finds a force loop that oscillates, from its error alone (Hägglund 1995, "A control-loop performance monitor"): an error
/// that crosses zero again and again with large means of its size in between. Between steps of the reference or of the load
/// a stable loop's error decays; it crosses zero a few times and becomes small.
class OscillationMonitor {
 public:
  /// Half a cycle lasts from kShortest to kLongest ticks: at 1 kHz 42 to 250 Hz, around the crossover of a loop with the
  /// delay of a tick or two.
  static constexpr int kShortest = 3, kLongest = 8;
  /// Mean size of the error over half a cycle, share of the force of the supply's pressure on the piston. Walks with the
  /// right gains have up to five such half cycles in a row, walks over high blocks now and then eleven.
  static constexpr double kLargeError = 0.1;
  static constexpr int kHalfCycles = 7;

  /// Takes the error of the next tick as a share of that force, and says whether the loop oscillates.
  bool take(double error) noexcept {
    const bool positive = error > 0.0;
    if (positive != positive_) {
      const bool large = ticks_ >= kShortest && ticks_ <= kLongest && sum_ >= kLargeError * ticks_;
      half_cycles_ = large ? half_cycles_ + 1 : 0;
      positive_ = positive;
      ticks_ = 0;
      sum_ = 0.0;
    }
    ++ticks_;
    sum_ += std::abs(error);
    return half_cycles_ >= kHalfCycles;
  }

  /// Forgets the half cycles so far.
  void reset() noexcept { *this = OscillationMonitor(); }

 private:
  bool positive_ = false;
  int ticks_ = 0;        ///< of this half cycle
  double sum_ = 0.0;     ///< of the error's size over it
  int half_cycles_ = 0;  ///< large ones in a row
};

}  // namespace farrier::estimation
