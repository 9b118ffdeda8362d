#pragma once

namespace farrier::plant {

struct SineCosine {
  double sine;
  double cosine;
};

/// Sine and cosine of an angle (rad) within [-8, 8], to 1e-15, from +, -, * alone: the linkage of a simulated joint
/// shapes its trace, and C libraries differ in the last bit. Larger or non-finite angles give NaN.
SineCosine sine_cosine(double angle_rad) noexcept;

/// Angle (rad, in [0, pi]) of a cosine; arguments beyond [-1, 1] act as the nearer end. To 1e-14 inside
/// [-0.999, 0.999], from +, -, *, / and sqrt alone. NaN gives NaN.
double arc_cosine(double cosine) noexcept;

}  // namespace farrier::plant
