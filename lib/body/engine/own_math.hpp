#pragma once

namespace farrier::body::own_math {

// The functions of the C library that the engine calls in a step, from +, -, *, / and sqrt alone. The C library picks
// other variants on other processors, which differ in the last bit and would make a trace depend on the machine.

/// To 1e-15 for |x| <= 8, NaN beyond: joint angles and rotations in one step are smaller.
double sine(double x) noexcept;
double cosine(double x) noexcept;
void sine_cosine(double x, double* sine, double* cosine) noexcept;

/// atan2(y, x), to 1e-15. NaN gives NaN.
double arc_tangent(double y, double x) noexcept;

/// base^exponent for a whole exponent in [0, 16], by multiplication; NaN for others.
double power(double base, double exponent) noexcept;

/// Stands for a function that the engine must not call in a step: NaN, which ends the run with a fault.
double forbidden(double x) noexcept;

}  // namespace farrier::body::own_math
