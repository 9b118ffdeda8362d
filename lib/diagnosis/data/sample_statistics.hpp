#pragma once

#include <optional>
#include <span>

namespace farrier::diagnosis {

// The functions need at least one finite value.

/// Value below which this share of all lie; share in [0, 1].
double quantile(std::span<const double> values, double share);

/// Magnitude below which this share of the values lies: a few spikes do not determine the unit.
double magnitude(std::span<const double> values, double share = 0.99);

double mean(std::span<const double> values);

/// About `middle`.
double rms(std::span<const double> values, double middle);

/// rms about the mean.
double standard_deviation(std::span<const double> values);

/// Comparison of a velocity with the derivative of a position.
struct Agreement {
  double ratio;        ///< of the first to the second, by least squares
  double correlation;  ///< in [-1, 1]
};

/// Over any time the mean velocity is the position's difference. The time used, of 10 to 300 ms, is the one over which
/// they agree best, so that neither noise nor an oscillation within it hides the agreement. Spikes and a constant
/// offset do not count. Empty if one of the two is constant, or the recording is shorter than eight such times.
std::optional<Agreement> agreement_of(std::span<const double> position, std::span<const double> velocity,
                                      double period_s);

}  // namespace farrier::diagnosis
