#include "control/design/pole_placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "control/numerics/francis.hpp"
#include "control/design/gain_design.hpp"
#include "control/model/plant_polynomials.hpp"

namespace farrier::control {
namespace {

using namespace gain_design;
using Complex = std::complex<double>;

constexpr double kMinDamping = 0.1;
constexpr double kMaxDamping = 5.0;
constexpr double kSlowestZero = 0.9995;
constexpr double kSubdiagonalThreshold = 1e-13;  // of the norm of [b, A]
constexpr double kPlacedTolerance = 1e-3;        // in z; four poles at the origin scatter by eps^(1/4) = 1e-4

Complex tamed(Complex zero) noexcept {
  if (!(zero.real() > 0.0)) {
    return 0.0;
  }
  const double modulus = std::abs(zero);
  const Complex inside = modulus > 1.0 ? 1.0 / std::conj(zero) : zero;
  return modulus > kSlowestZero && modulus < 1.0 / kSlowestZero ? zero * (kSlowestZero / modulus) : inside;
}

/// Roots of c[2] z^2 + c[1] z + c[0] without cancellation; of the two poles at the origin where c[2] is zero.
std::array<Complex, 2> roots(const std::array<double, 3>& c) noexcept {
  const double half = -0.5 * c[1] / c[2];
  const double product = c[0] / c[2];
  const double inside = half * half - product;
  if (!std::isfinite(inside)) {
    return {0.0, 0.0};
  }
  if (inside < 0.0) {
    const double imaginary = std::sqrt(-inside);
    return {Complex(half, imaginary), Complex(half, -imaginary)};
  }
  const double larger = half + std::copysign(std::sqrt(inside), half);
  return {larger, larger != 0.0 ? product / larger : 0.0};
}

/// (a, b) after orthogonal similarity: a is Hessenberg, b a multiple of e_1; `back` is the product of the reflections.
template <int N>
struct ControllerHessenberg {
  Square<N> h;
  double b_1;
  Square<N> back;
};

template <int N>
ControllerHessenberg<N> controller_hessenberg(const Square<N>& a, const Column<N>& b) noexcept {
  ControllerHessenberg<N> form{a, 0.0, Square<N>::Identity()};
  Column<N> column = b;
  for (int first = 0; first < N - 1; ++first) {
    // Householder: I - 2 w w' / w'w makes the column zero below `first`.
    Column<N> w = Column<N>::Zero();
    w.tail(N - first) = column.tail(N - first);
    const double size = w.norm();
    w(first) += std::copysign(size, w(first));
    const double square = w.squaredNorm();
    if (square > 0.0) {
      form.h -= (2.0 / square) * w * (w.transpose() * form.h).eval();
      form.h -= (form.h * w).eval() * ((2.0 / square) * w.transpose());
      form.back -= (form.back * w).eval() * ((2.0 / square) * w.transpose());
    }
    column = form.h.col(first);
  }
  form.b_1 = form.back.col(0).dot(b);
  return form;
}

/// Largest distance of an eigenvalue of `m` from the pole it is paired with, nearest first; infinite when the
/// eigenvalues cannot be computed.
template <int N>
double misplacement(const Square<N>& m, Eigen::Matrix<Complex, N, 1> poles) noexcept {
  Eigen::Matrix<Complex, N, 1> z;
  if (!francis_eigenvalues<N>(m, z)) {
    return std::numeric_limits<double>::infinity();
  }
  double worst = 0.0;
  for (int i = 0; i < N; ++i) {
    int nearest = i;
    for (int j = i; j < N; ++j) {
      nearest = std::abs(z(j) - poles(i)) < std::abs(z(nearest) - poles(i)) ? j : nearest;
    }
    worst = std::max(worst, std::abs(z(nearest) - poles(i)));
    std::swap(z(i), z(nearest));
  }
  return worst;
}

struct PlacementRule {
  std::array<Complex, 6> poles;

  template <int P, int D>
  Result<GainRow<P, D>, DesignStatus> operator()(const Augmented<P, D>& loop) const noexcept {
    constexpr int N = Augmented<P, D>::kStates;
    return place_poles<N>(loop.a, loop.b, Eigen::Map<const Eigen::Matrix<Complex, N, 1>>(poles.data()));
  }
};

}  // namespace

std::array<Complex, 6> wanted_poles(const DiscreteModel& model, const PolePlacement& poles, Form form,
                                    double period_s) noexcept {
  const double w = poles.bandwidth_rad_s * period_s;
  const double inside = poles.damping * poles.damping - 1.0;
  const Complex root = inside < 0.0 ? Complex(0.0, std::sqrt(-inside)) : Complex(std::sqrt(inside), 0.0);
  std::array<Complex, 6> wanted{std::exp(w * (-poles.damping + root)), std::exp(w * (-poles.damping - root))};
  const PlantPolynomials plant = plant_polynomials(model, form);
  if (form == Form::kCompliant) {
    wanted[2] = tamed(-plant.force[0] / plant.force[1]);
    return wanted;
  }
  const std::array<Complex, 2> zeros = roots(plant.force);
  wanted[2] = tamed(zeros[0]);
  wanted[3] = tamed(zeros[1]);
  return wanted;
}

template <int N>
Result<Eigen::Matrix<double, 1, N>, DesignStatus> place_poles(
    const Square<N>& a, const Column<N>& b, const Eigen::Matrix<Complex, N, 1>& poles) noexcept {
  using Row = Eigen::Matrix<double, 1, N>;
  const ControllerHessenberg<N> form = controller_hessenberg<N>(a, b);
  const double threshold = kSubdiagonalThreshold * std::sqrt(a.squaredNorm() + b.squaredNorm());
  // What each factor's row is divided by, from the last subdiagonal up to b: the row stays of the size of the poles.
  const auto divisor = [&form](int factor) {
    return factor == N - 1 ? form.b_1 : form.h(N - 1 - factor, N - 2 - factor);
  };
  for (int i = 0; i < N; ++i) {
    if (!(std::abs(divisor(i)) > threshold)) {
      return std::isfinite(threshold) ? DesignStatus::kNotControllable : DesignStatus::kModelNotFinite;
    }
  }
  Row row = Row::Unit(N - 1);
  for (int i = 0; i < N; ++i) {
    if (poles(i).imag() == 0.0 || i == N - 1) {
      row = ((row * form.h - poles(i).real() * row) / divisor(i)).eval();
    } else {
      // (H - z I)(H - z* I) = H^2 - 2 Re z H + |z|^2 I
      const Row once = row * form.h / divisor(i);
      row = (once * form.h - 2.0 * poles(i).real() * once + (std::norm(poles(i)) / divisor(i)) * row) / divisor(i + 1);
      ++i;
    }
  }
  const Row k = row * form.back.transpose();
  if (!(misplacement<N>(a - b * k, poles) <= kPlacedTolerance)) {
    return DesignStatus::kPolesNotPlaced;
  }
  return k;
}

#define FARRIER_INSTANTIATE(N)                                                                            \
  template Result<Eigen::Matrix<double, 1, N>, DesignStatus> place_poles<N>(                              \
      const Square<N>&, const Column<N>&, const Eigen::Matrix<Complex, N, 1>&) noexcept;
FARRIER_INSTANTIATE(2)
FARRIER_INSTANTIATE(3)
FARRIER_INSTANTIATE(4)
FARRIER_INSTANTIATE(5)
FARRIER_INSTANTIATE(6)
#undef FARRIER_INSTANTIATE

Result<Gains, DesignStatus> design_pole_placement(const DiscreteModel& model, const PolePlacement& poles,
                                                  double feed_forward_factor, const Normalisation& normalisation,
                                                  Form form, int delay_ticks, double period_s) noexcept {
  const Problem problem{model, normalisation, form, delay_ticks, feed_forward_factor};
  const DesignStatus status = check(problem);
  if (status != DesignStatus::kSuccessful) {
    return status;
  }
  if (!(period_s > 0.0 && period_s <= kMaxPeriodS)) {
    return DesignStatus::kWrongSamplingTime;
  }
  if (!(poles.bandwidth_rad_s > 0.0 && poles.bandwidth_rad_s * period_s < std::numbers::pi) ||
      !(poles.damping >= kMinDamping && poles.damping <= kMaxDamping)) {
    return DesignStatus::kPolesOutOfBounds;
  }
  return find_gains(problem, 1.0, PlacementRule{wanted_poles(model, poles, form, period_s)});
}

}  // namespace farrier::control
