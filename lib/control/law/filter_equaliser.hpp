#pragma once

#include "control/law/force_controller.hpp"
#include "control/law/low_pass.hpp"

namespace farrier::control {

/// Low-passes on the channels of a measurement that make them lag alike. Default: passes everything.
class FilterEqualiser {
 public:
  FilterEqualiser() = default;
  FilterEqualiser(const FilterCoefficients& position, const FilterCoefficients& velocity,
                  const FilterCoefficients& force) noexcept
      : position_(position), velocity_(velocity), force_(force) {}

  /// Takes a period's measurement. The first counts as having been there always.
  Measurement take(const Measurement& read) noexcept {
    if (!settled_) {
      position_.settle(read.position);
      velocity_.settle(read.velocity);
      force_.settle(read.force);
      settled_ = true;
    }
    return {position_.take(read.position), velocity_.take(read.velocity), force_.take(read.force)};
  }
  /// Forgets the past.
  void reset() noexcept { settled_ = false; }

 private:
  LowPass position_, velocity_, force_;
  bool settled_ = false;
};

}  // namespace farrier::control
