#pragma once

#include <array>
#include <functional>

#include "diagnosis/judge/hypothesis.hpp"

namespace farrier::diagnosis {

/// Remainder on a channel that the model's sensors do not explain.
struct Remainder {
  double rms;       ///< of the held-out residual, N | m/s
  double expected;  ///< of a twin of the model with its sensors' noise
  double nrmse;     ///< rms over the standard deviation of the measurement
};

/// The rms of a change, over that of independent noise, with which the rms of both is larger than the noise by `share` of it.
double visible_beside_noise(double share) noexcept;

/// Root mean square by channel of a hypothesis's residuals if it were right.
using ExpectedResiduals = std::function<std::array<double, kChannels>(const Hypothesis& hypothesis)>;

/// Remainders of the channels that are judged, 0 of the others.
std::array<Remainder, kChannels> remainder(const Bench& bench, const Hypothesis& hypothesis,
                                           const ExpectedResiduals& expected_residuals);

}  // namespace farrier::diagnosis
