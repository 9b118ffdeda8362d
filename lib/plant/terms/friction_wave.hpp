#pragma once

#include <cmath>
#include <numbers>

#include "core/portable_math.hpp"

namespace farrier::plant {

/// Dry friction that swings with the position, as on a bent rod or a guide that is worn in one place: its level over
/// the mean is 1 + w cos(2 pi (x - x_t) / lambda). Breakaway and Coulomb friction swing together; the bristles'
/// stiffness stays.
template <class T>
struct FrictionWave {
  T waviness;    ///< w, in [0, 1)
  T wavelength;  ///< lambda, m or rad; > 0
  T tightest;    ///< x_t, a position of the largest friction, m or rad

  T level(const T& position) const noexcept {
    using portable::cos;
    return 1.0 + waviness * cos(2.0 * std::numbers::pi * (position - tightest) / wavelength);
  }
};

}  // namespace farrier::plant
