#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/portable_math.hpp"

namespace farrier::estimation {

/// Statistics of a model's one-step prediction errors e[k]: their size and their whiteness. Errors are white if none
/// can be predicted from earlier ones. Both over an exponential window.
class PredictionErrors {
 public:
  static constexpr double kMemory = 0.98;  ///< weight of an error against the next one's: 50 ticks
  static constexpr std::size_t kLags = 4;  ///< even: the distribution's tail is then a finite sum
  /// White errors' autocorrelation under this window has the variance (1 - kMemory) / (1 + kMemory).
  static constexpr double kSamples = (1.0 + kMemory) / (1.0 - kMemory);

  /// The next error is not one tick after the last.
  void interrupt() noexcept { known_ = 0; }

  /// Takes the error of the next tick, |error| <= 1e40.
  void take(double error) noexcept {
    // c_i <- lambda c_i + (1 - lambda) e[k] e[k-i]
    variance_ = kMemory * variance_ + (1.0 - kMemory) * (error * error);
    for (std::size_t i = 0; i < known_; ++i) {
      covariance_[i] = kMemory * covariance_[i] + (1.0 - kMemory) * (error * last_[i]);
    }
    std::copy_backward(last_.begin(), last_.end() - 1, last_.end());
    last_[0] = error;
    known_ = std::min(known_ + 1, kLags);
  }

  /// c_0: zero before the first error.
  double variance() const noexcept { return variance_; }

  /// Autocorrelation r_i = c_i / c_0 at lag i = 1..kLags, in [-1, 1]; zero while there is no error, one when errors
  /// have become too large to be squared.
  double autocorrelation(std::size_t lag) const noexcept {
    if (!std::isfinite(variance_)) {
      return 1.0;
    }
    return variance_ > 0.0 ? std::clamp(covariance_[lag - 1] / variance_, -1.0, 1.0) : 0.0;
  }

  /// Probability that white errors are at least as correlated as these, 0..1 (Box and Pierce 1970). Their n is for a
  /// window of equal weights; this n gives r_i its variance:
  ///
  ///     Q = n sum_i r_i^2 ~ chi^2(m),   P(chi^2(m) >= Q) = exp(-Q/2) sum_{j < m/2} (Q/2)^j / j!   for even m
  double whiteness() const noexcept {
    double half = 0.0;
    for (std::size_t lag = 1; lag <= kLags; ++lag) {
      half += 0.5 * kSamples * autocorrelation(lag) * autocorrelation(lag);
    }
    double term = 1.0, sum = 1.0;
    for (std::size_t j = 1; j < kLags / 2; ++j) {
      term *= half / static_cast<double>(j);
      sum += term;
    }
    return portable::exp(-half) * sum;
  }

 private:
  static_assert(kLags % 2 == 0);

  double variance_ = 0.0;
  std::array<double, kLags> covariance_{};
  std::array<double, kLags> last_{};  // newest first
  std::size_t known_ = 0;             // of last_
};

}  // namespace farrier::estimation
