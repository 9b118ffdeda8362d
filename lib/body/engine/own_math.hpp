#pragma once

/// Functions that the engine calls in a step in place of the C library, in the C library's own form, beside those of
/// core/portable_math.hpp.
namespace farrier::body::own_math {

void sine_cosine(double x, double* sine, double* cosine) noexcept;

/// base^exponent for a whole exponent in [0, 16], by multiplication; NaN for others.
double power(double base, double exponent) noexcept;

/// Stands for a function that the engine must not call in a step: NaN, which ends the run with a fault.
double forbidden(double x) noexcept;

}  // namespace farrier::body::own_math
