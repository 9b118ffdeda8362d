#pragma once

#include "participant/clock.hpp"
#include "robot/robot.hpp"
#include "tools/ros/ros_names.hpp"

namespace farrier::ros_bridge {

/// Stamps of messages: the date when a sample was taken, or the simulation's time.
class SampleStamps {
 public:
  SampleStamps(double period_s, bool simulated) : period_s_(period_s), simulated_(simulated) {}

  /// `sampled_ns`: the sampling computer's steady clock, which may count from another begin than this one's. An age that
  /// cannot be is left out.
  Time of(Tick tick, std::int64_t sampled_ns) const {
    using namespace std::chrono_literals;
    if (simulated_) {
      return ros_view::time_of(static_cast<std::int64_t>(static_cast<double>(tick) * period_s_ * 1e9));
    }
    // Both clocks are read together: this process may wait for a processor between two steps of its loop.
    const SteadyTime now = participant::steady_now();
    const auto date_ns = static_cast<std::int64_t>(participant::date_now_ns());
    const std::int64_t age_ns = now.time_since_epoch().count() - sampled_ns;
    const bool possible = sampled_ns > 0 && age_ns >= 0 && age_ns < Nanoseconds(1s).count();
    return ros_view::time_of(possible ? date_ns - age_ns : date_ns);
  }
  /// Stamp of something that is said now.
  Time of_now(Tick tick) const { return of(tick, 0); }

 private:
  double period_s_;
  bool simulated_;
};

}  // namespace farrier::ros_bridge
