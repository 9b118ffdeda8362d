#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "diagnosis/data/recording.hpp"
#include "robot/robot.hpp"

namespace farrier::diagnosis {

/// Columns of a recording that a cable or a driver can confuse.
enum class WiredChannel { kPosition, kVelocity, kForce, kCurrent, kPressureA, kPressureB, kSupply };
inline constexpr std::size_t kWiredChannels = 7;

/// Columns of a recording, low-passed alike, at the middles of its periods. A linear relation between channels holds for
/// them as it does for the channels. Those of a channel that was not recorded are empty.
struct WiringSignals {
  WiringSignals(const Recording& recording, const robot::Joint& joint);

  std::size_t size() const noexcept { return position[0].size(); }

  std::array<std::vector<double>, 4> position;        ///< and its three derivatives
  std::array<std::vector<double>, 3> velocity;        ///< and its two derivatives
  std::vector<double> travel;                         ///< integral of the velocity, without what lasts longer than 1 s
  std::array<std::vector<double>, 3> quick_velocity;  ///< and its two derivatives, without the same
  std::vector<double> quick_force;                    ///< without the same
  std::array<std::vector<double>, 3> force;           ///< and its two derivatives
  /// The current times the root of the pressure drop at its ports over that of half the supply, for the force as it is
  /// and for the reversed one; the current itself.
  std::array<std::vector<double>, 3> current;
  std::vector<double> pressure_a, pressure_b;
  std::vector<char> load_known;  ///< 1: the load is the one of the model, all along the low-pass
  std::size_t width;             ///< samples before and after a middle that it depends on
};

}  // namespace farrier::diagnosis
