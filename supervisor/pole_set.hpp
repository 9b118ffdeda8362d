#pragma once

#include <array>
#include <complex>

#include "control/design/lqr.hpp"

namespace farrier::supervisor {

/// Poles of a joint's model that a loop of its form rests on: three, or the two of velocity and force, and zero, for
/// the compliant form, in which the position is free.
using PoleSet = std::array<std::complex<double>, 3>;

PoleSet poles_of(const control::DiscreteModel& model, control::Form form) noexcept;

/// Distance of two such sets, estimation::pole_distance.
double distance(const PoleSet& a, const PoleSet& b, control::Form form) noexcept;

}  // namespace farrier::supervisor
