#pragma once

#include <optional>

#include "core/result.hpp"
#include "robot/robot.hpp"

namespace farrier::trials {

/// A joint whose piston is held at one place, and the node that controls its force.
struct HeldJoint {
  robot::Joint real;      ///< as it is simulated; its sensors' noise is left out
  robot::Joint designed;  ///< of the node
  robot::Joint known;     ///< whose gains and physics the node is told
  double angle_rad;       ///< at which it is held, between the joint's limits
  double period_s;
  int delay_ticks;  ///< from a sample to the valve current that answers it
};

/// Bandwidth of a closed force loop for sines of one amplitude. Above kHighest_Hz nothing is measured.
struct ForceBandwidth {
  static constexpr double kHighest_Hz = 400.0;
  std::optional<double> gain_Hz;   ///< where the amplitude of the force falls by 3 dB; none up to kHighest_Hz
  std::optional<double> phase_Hz;  ///< where the force lags by 90 degrees; none up to kHighest_Hz
  bool swings = false;  ///< the loop oscillates by itself: at 2 Hz more than half of the force is no part of the sine
};

/// The force reference is a sine of `amplitude` (N or Nm, > 0) about zero, at 2 Hz and then at each even frequency that is
/// higher by 8 % or more. Its response is the Fourier coefficient of the load cell's true force over half a second, after a
/// quarter of a second from rest; between frequencies it is interpolated by the logarithm of the frequency. Refuses what
/// armed_joint does and a joint that cannot be simulated.
Result<ForceBandwidth> force_bandwidth(const HeldJoint& joint, double amplitude);

/// Frequency at which the valve's spool lags by 90 degrees, its natural frequency (Hubacher 2014, (2.18)), Hz; none for a
/// spool that follows at once.
std::optional<double> spool_Hz(const robot::Joint& real);

/// Frequency at which a sine of the force takes the flow of the open valve when it crosses zero, F'_max / (2 pi F) in Hz. Here
/// F'_max = A_p K_uv sqrt(drop) u_max of the slower direction (Hubacher 2014, (3.26), (3.33)).
double full_flow_Hz(const robot::Joint& real, double angle_rad, double amplitude);

}  // namespace farrier::trials
