#pragma once

#include <complex>

#include "core/portable_math.hpp"

// Functions of complex numbers whose results reach a trace. Internal to control.
namespace farrier::control {

/// e^(i angle), angle (rad) within [-1e6, 1e6]; NaN beyond.
inline std::complex<double> unit_circle(double angle_rad) noexcept {
  const portable::SineCosine at = portable::sincos(angle_rad);
  return {at.cosine, at.sine};
}

/// Angle (rad) of z in [-pi, pi]; NaN for a number that is not finite.
inline double angle_of(std::complex<double> z) noexcept { return portable::atan2(z.imag(), z.real()); }

/// e^z, the imaginary part within [-1e6, 1e6].
inline std::complex<double> exponential(std::complex<double> z) noexcept {
  return portable::exp(z.real()) * unit_circle(z.imag());
}

}  // namespace farrier::control
