#pragma once

#include <algorithm>
#include <span>

#include "core/phase.hpp"
#include "core/time.hpp"

namespace farrier::gait {

/// Counts the touchdowns of a leg that come while its joints still have the gains of swing. A foot that has not yet left
/// the ground at the start of its swing is not late.
class LateTouchdowns {
 public:
  /// Advances by one tick: the true contact of the foot, and the phase whose gains act.
  void step(Phase contact, Phase acting) noexcept {
    if (acting == Phase::kStance) {
      left_ = false;
      now_ticks_ = 0;
    } else if (contact == Phase::kSwing) {
      left_ = true;
      now_ticks_ = 0;
    } else if (left_) {
      count_ += now_ticks_ == 0 ? 1 : 0;
      ++ticks_;
      largest_ticks_ = std::max(largest_ticks_, ++now_ticks_);
    }
  }

  int count() const noexcept { return count_; }
  /// Until the gains of stance act or the foot leaves again, the sum over these touchdowns.
  Tick ticks() const noexcept { return ticks_; }
  Tick largest_ticks() const noexcept { return largest_ticks_; }

 private:
  bool left_ = false;
  Tick now_ticks_ = 0, ticks_ = 0, largest_ticks_ = 0;
  int count_ = 0;
};

/// The late touchdowns of several legs.
struct LateTotal {
  int count = 0;
  double sum = 0.0, largest = 0.0;  ///< LateTouchdowns::ticks, in ticks or in the unit asked for
};

/// `tick`: length of a tick in the unit asked for.
inline LateTotal total_of(std::span<const LateTouchdowns> legs, double tick = 1.0) noexcept {
  LateTotal total;
  for (const LateTouchdowns& leg : legs) {
    total.count += leg.count();
    total.sum += tick * static_cast<double>(leg.ticks());
    total.largest = std::max(total.largest, tick * static_cast<double>(leg.largest_ticks()));
  }
  return total;
}

}  // namespace farrier::gait
