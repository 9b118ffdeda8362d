#pragma once

#include <array>
#include <optional>

namespace farrier::control {

/// A low-pass as a data sheet gives it. Cut-off 0: none.
struct LowPassParams {
  double cut_off_Hz = 0.0;  ///< of order 1: -3 dB; of order 2: natural frequency; 0, or within (0, 0.45 rate]
  int order = 2;            ///< 1 or 2
  double damping = 0.7071;  ///< of order 2; > 0
};

/// Largest cut-off over the sampling rate: beyond it the discrete filter is no low-pass any more.
inline constexpr double kLargestCutOffShare = 0.45;

/// y[k] = b0 u[k] + b1 u[k-1] + b2 u[k-2] - a1 y[k-1] - a2 y[k-2]; default: y = u. For a loop's margin with the filter
/// inside: the transfer function is (b0 + b1 z^-1 + b2 z^-2) / (1 + a1 z^-1 + a2 z^-2).
struct FilterCoefficients {
  std::array<double, 3> b{1.0, 0.0, 0.0};
  std::array<double, 2> a{0.0, 0.0};  ///< a1, a2

  friend bool operator==(const FilterCoefficients&, const FilterCoefficients&) = default;
};

/// Bilinear transform of 1 / (s / w + 1) or 1 / (s^2 / w^2 + 2 D s / w + 1), prewarped: the response at the cut-off is
/// the continuous one's (Franklin, Powell and Workman 1998, 6.1). The sampling rate `rate_Hz` is > 0. Empty for
/// parameters outside the ranges above. The result is the same on every machine.
std::optional<FilterCoefficients> design_low_pass(const LowPassParams& params, double rate_Hz) noexcept;

/// The filter at run time, transposed direct form II. Finite input gives finite output.
class LowPass {
 public:
  LowPass() = default;
  explicit LowPass(const FilterCoefficients& coefficients) noexcept : c_(coefficients) {}

  /// Sets the state as if `value` had always been the input.
  void settle(double value) noexcept;
  double take(double value) noexcept;

  const FilterCoefficients& coefficients() const noexcept { return c_; }

 private:
  FilterCoefficients c_;
  double first_ = 0.0;
  double second_ = 0.0;
};

}  // namespace farrier::control
