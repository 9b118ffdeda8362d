#pragma once

#include <span>
#include <vector>

namespace farrier::diagnosis {

/// A velocity that was not measured.
struct DerivedVelocity {
  std::vector<double> velocity;  ///< m/s or rad/s, as many as positions
  int half_window = 0;           ///< samples on either side; 0: too few positions, velocity 0
  double noise = 0.0;            ///< its standard deviation inside, m/s or rad/s; larger within half_window of the ends
  double bias = 0.0;             ///< RMS of the part that the window smooths away, m/s or rad/s, as estimated; 0: not
                                 ///< seen
};

/// Standard deviation of white noise on a smooth signal, from its repeated differences: those of order d have the
/// variance binomial(2 d, d) sigma^2, and a smooth signal leaves less the higher the order. At least a twelfth of the
/// square of the sensor's step, where the values lie on steps. 0 for fewer than 32 values.
double white_noise(std::span<const double> values);

/// Derivative of positions at a uniform period: slope at its middle of the parabola that fits a window by least squares
/// (Savitzky and Golay 1964). The window, up to 0.1 s on either side, is the one of least estimated error, noise and
/// bias together, judged against the shortest (unbiased risk, Mallows 1973). No delay. Needs a finite `position` and
/// `period_s` > 0.
DerivedVelocity derive_velocity(std::span<const double> position, double period_s);

}  // namespace farrier::diagnosis
