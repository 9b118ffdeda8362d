#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace farrier::plant {

inline constexpr double kSafety = 0.9;
inline constexpr double kMostGrowth = 4.0;
inline constexpr double kMostShrink = 0.2;

/// Step-size factor kSafety r^(-1/5) for an error ratio r of a fifth-order step. The root is read off the exponent
/// bits (a piecewise linear logarithm, within 3 %): a step size needs no more, and no C library enters the trace.
inline double substep_factor(double ratio) noexcept {
  if (!(ratio > 1e-6)) {
    return ratio <= 1e-6 ? kMostGrowth : kMostShrink;  // not a number: the trial left the finite numbers
  }
  constexpr std::uint64_t kSixFifthsOfOne = std::bit_cast<std::uint64_t>(1.0) / 5 * 6;
  const double root = std::bit_cast<double>(kSixFifthsOfOne - std::bit_cast<std::uint64_t>(ratio) / 5);
  return std::clamp(kSafety * root, kMostShrink, kMostGrowth);
}

/// True if a chamber's pressure strides over a place where the right-hand side bends sharply, so that a substep's few
/// stages may miss it. Such places are the start of a void and the laminar range of its open port. The path between
/// both ends lies within the Bezier polygon of their values and rates.
inline bool strides_over_bend(double start, double start_rate, double end, double end_rate, double port, double laminar,
                       double h) noexcept {
  const double third = h * (1.0 / 3.0);
  const double after = start + third * start_rate;
  const double before = end - third * end_rate;
  const double low = std::min(std::min(start, end), std::min(after, before));
  const double high = std::max(std::max(start, end), std::max(after, before));
  const bool strides = high - low > 0.5 * laminar;
  const bool at_port = low < port + 5.0 * laminar && high > port - 5.0 * laminar;
  const bool at_void = low < laminar && high > 0.0;
  return strides && (at_port || at_void);
}

}  // namespace farrier::plant
