#pragma once

#include <array>
#include <complex>
#include <string>

namespace farrier::monitor {

/// "0.912 0.300+-0.200i": a conjugate pair is written once. "-" when a pole is not a number.
std::string poles_text(const std::array<std::complex<double>, 3>& poles);

}  // namespace farrier::monitor
