#include "control/model/part_of_tick.hpp"

#include <cmath>

#include "core/portable_math.hpp"
#include "control/numerics/complex_math.hpp"
#include "control/numerics/spectrum.hpp"

namespace farrier::control {
namespace {

using Complex = std::complex<double>;

constexpr double kTogether = 1e-6;  // poles nearer than this count as one, with the derivative at their middle

/// z^s.
Complex power(Complex z, double share) noexcept {
  return portable::pow(std::abs(z), share) * unit_circle(share * angle_of(z));
}

/// f(z) = (z^s - 1) / (z - 1), f(1) = s.
Complex held(Complex z, double share) noexcept {
  const Complex from_one = z - 1.0;
  return std::abs(from_one) < kTogether ? Complex(share + 0.5 * share * (share - 1.0) * from_one)
                                        : (power(z, share) - 1.0) / from_one;
}

/// (f(y) - f(x)) / (y - x).
Complex difference(Complex x, Complex y, double share) noexcept {
  if (std::abs(y - x) >= kTogether) {
    return (held(y, share) - held(x, share)) / (y - x);
  }
  constexpr double kStep = 1e-4;
  const Complex middle = 0.5 * (x + y);
  return (held(middle + kStep, share) - held(middle - kStep, share)) / (2.0 * kStep);
}

}  // namespace

PartOfTick::PartOfTick(const DiscreteModel& model) noexcept {
  const SmallSpectrum poles = eigenvalues(model.a);
  // Farthest apart first and last, so that the second difference divides by the largest distance.
  int first = 0, last = 1;
  for (const auto& [i, j] : {std::pair{0, 2}, std::pair{1, 2}}) {
    if (std::abs(poles(i) - poles(j)) > std::abs(poles(first) - poles(last))) {
      first = i;
      last = j;
    }
  }
  poles_[0] = poles(first);
  poles_[1] = poles(3 - first - last);
  poles_[2] = poles(last);
  directions_[0] = model.b.cast<Complex>();
  for (int i = 0; i < 2; ++i) {
    directions_[i + 1] = model.a.cast<Complex>() * directions_[i] - poles_[i] * directions_[i];
  }
}

Eigen::Vector3d PartOfTick::input(double share) const noexcept {
  const Complex one = difference(poles_[0], poles_[1], share);
  const Complex other = difference(poles_[1], poles_[2], share);
  const Complex apart = poles_[2] - poles_[0];
  const Complex second = std::abs(apart) >= kTogether ? (other - one) / apart : Complex(0.0);
  return (held(poles_[0], share) * directions_[0] + one * directions_[1] + second * directions_[2]).real();
}

}  // namespace farrier::control
