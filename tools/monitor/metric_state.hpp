#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/fault.hpp"
#include "monitor/frame.hpp"
#include "robot/robot.hpp"

namespace farrier::display {

/// The state that metrics are made of: the newest frame, and counts over all frames. The counts include frames between
/// two scrapes.
struct MetricState {
  const robot::Robot& robot;
  monitor::Frame frame;
  double frame_time_s = 0.0;  ///< date of the frame, since 1970; 0: none yet
  double start_time_s = 0.0;  ///< of the first
  std::array<std::uint64_t, 3> events{};                                      ///< by severity
  std::vector<std::array<std::uint64_t, kFaults.size()>> fault_onsets{};  ///< by joint and fault
  std::vector<std::uint32_t> last_faults{};                                    ///< of each joint's last summary

  /// Takes the next frame, made at this date.
  void take(const monitor::Frame& next, double time_s);
};

}  // namespace farrier::display
