#include "control/design/pole_placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "control/numerics/complex_math.hpp"
#include "control/numerics/spectrum.hpp"
#include "control/design/gain_design.hpp"
#include "control/model/plant_polynomials.hpp"
#include "control/numerics/sizes.hpp"

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

/// (a, b) after orthogonal similarity: h is Hessenberg, b a multiple of e_1; `back` is the product of the reflections.
struct ControllerHessenberg {
  SmallMatrix h;
  double b_1;
  SmallMatrix back;
};

/// m <- m - 2 m w w' / w'w.
void reflect_columns(SmallMatrix& m, const SmallColumn& w, double square) noexcept {
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    double sum = 0.0;
    for (Eigen::Index j = 0; j < m.cols(); ++j) {
      sum += m(i, j) * w(j);
    }
    for (Eigen::Index j = 0; j < m.cols(); ++j) {
      m(i, j) -= sum * (2.0 / square) * w(j);
    }
  }
}

ControllerHessenberg controller_hessenberg(const SmallMatrix& a, const SmallColumn& b) noexcept {
  const Eigen::Index n = a.rows();
  ControllerHessenberg form{a, 0.0, SmallMatrix(n, n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = 0; i < n; ++i) {
      form.back(i, j) = i == j ? 1.0 : 0.0;
    }
  }
  SmallColumn column = b;
  for (Eigen::Index first = 0; first < n - 1; ++first) {
    // Householder: I - 2 w w' / w'w makes the column zero below `first`.
    SmallColumn w(n);
    double square = 0.0;
    for (Eigen::Index i = 0; i < n; ++i) {
      w(i) = i < first ? 0.0 : column(i);
      square += w(i) * w(i);
    }
    w(first) += std::copysign(std::sqrt(square), w(first));
    square = 0.0;
    for (Eigen::Index i = first; i < n; ++i) {
      square += w(i) * w(i);
    }
    if (square > 0.0) {
      for (Eigen::Index j = 0; j < n; ++j) {
        double sum = 0.0;
        for (Eigen::Index i = first; i < n; ++i) {
          sum += w(i) * form.h(i, j);
        }
        for (Eigen::Index i = first; i < n; ++i) {
          form.h(i, j) -= sum * (2.0 / square) * w(i);
        }
      }
      reflect_columns(form.h, w, square);
      reflect_columns(form.back, w, square);
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      column(i) = form.h(i, first);
    }
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    form.b_1 += form.back(i, 0) * b(i);
  }
  return form;
}

/// row <- row m.
SmallColumn row_times(const SmallColumn& row, const SmallMatrix& m) noexcept {
  SmallColumn product(m.cols());
  for (Eigen::Index j = 0; j < m.cols(); ++j) {
    product(j) = 0.0;
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
      product(j) += row(i) * m(i, j);
    }
  }
  return product;
}

/// Largest distance of an eigenvalue of `m` from the pole it is paired with, nearest first; infinite when the
/// eigenvalues cannot be computed.
double misplacement(const SmallMatrix& m, const SmallSpectrum& poles) noexcept {
  SmallSpectrum z = eigenvalues(m);
  if (z.hasNaN()) {
    return std::numeric_limits<double>::infinity();
  }
  double worst = 0.0;
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    Eigen::Index nearest = i;
    for (Eigen::Index j = i; j < z.size(); ++j) {
      nearest = std::abs(z(j) - poles(i)) < std::abs(z(nearest) - poles(i)) ? j : nearest;
    }
    worst = std::max(worst, std::abs(z(nearest) - poles(i)));
    std::swap(z(i), z(nearest));
  }
  return worst;
}

/// place_poles for any number of states up to kMaxStates; `k` is the row.
DesignStatus place(const SmallMatrix& a, const SmallColumn& b, const SmallSpectrum& poles, SmallColumn& k) noexcept {
  const Eigen::Index n = a.rows();
  const ControllerHessenberg form = controller_hessenberg(a, b);
  const double threshold = kSubdiagonalThreshold * std::sqrt(a.squaredNorm() + b.squaredNorm());
  // The divisor of each factor's row, from the last subdiagonal up to b: the row stays of the size of the poles.
  const auto divisor = [&form, n](Eigen::Index factor) {
    return factor == n - 1 ? form.b_1 : form.h(n - 1 - factor, n - 2 - factor);
  };
  for (Eigen::Index i = 0; i < n; ++i) {
    if (!(std::abs(divisor(i)) > threshold)) {
      return std::isfinite(threshold) ? DesignStatus::kNotControllable : DesignStatus::kModelNotFinite;
    }
  }
  SmallColumn row(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    row(i) = i == n - 1 ? 1.0 : 0.0;
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const SmallColumn once = row_times(row, form.h);
    if (poles(i).imag() == 0.0 || i == n - 1) {
      for (Eigen::Index j = 0; j < n; ++j) {
        row(j) = (once(j) - poles(i).real() * row(j)) / divisor(i);
      }
    } else {
      // (H - z I)(H - z* I) = H^2 - 2 Re z H + |z|^2 I
      const SmallColumn twice = row_times(once, form.h);
      for (Eigen::Index j = 0; j < n; ++j) {
        row(j) =
            (twice(j) - 2.0 * poles(i).real() * once(j) + std::norm(poles(i)) * row(j)) / divisor(i) / divisor(i + 1);
      }
      ++i;
    }
  }
  k.resize(n);
  SmallMatrix closed = a;
  for (Eigen::Index j = 0; j < n; ++j) {
    k(j) = 0.0;
    for (Eigen::Index i = 0; i < n; ++i) {
      k(j) += row(i) * form.back(j, i);
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      closed(i, j) -= b(i) * k(j);
    }
  }
  return misplacement(closed, poles) <= kPlacedTolerance ? DesignStatus::kSuccessful : DesignStatus::kPolesNotPlaced;
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
  std::array<Complex, 6> wanted{exponential(w * (-poles.damping + root)), exponential(w * (-poles.damping - root))};
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
Result<Eigen::Matrix<double, 1, N>, DesignStatus> place_poles(const Square<N>& a, const Column<N>& b,
                                                              const Eigen::Matrix<Complex, N, 1>& poles) noexcept {
  SmallColumn k;
  if (const DesignStatus status = place(a, b, poles, k); status != DesignStatus::kSuccessful) {
    return status;
  }
  return Eigen::Matrix<double, 1, N>(k.transpose());
}

#define FARRIER_INSTANTIATE(N)                                               \
  template Result<Eigen::Matrix<double, 1, N>, DesignStatus> place_poles<N>( \
      const Square<N>&, const Column<N>&, const Eigen::Matrix<Complex, N, 1>&) noexcept;
FARRIER_FOR_EACH_SIZE(FARRIER_INSTANTIATE)
#undef FARRIER_INSTANTIATE

Result<Gains, DesignStatus> design_pole_placement(const DiscreteModel& model, const PolePlacement& poles,
                                                  double feed_forward_factor, const Normalisation& normalisation,
                                                  Form form, int delay_ticks, double period_s,
                                                  SmallSpectrum* found) noexcept {
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
  return find_gains(problem, 1.0, PlacementRule{wanted_poles(model, poles, form, period_s)}, found);
}

}  // namespace farrier::control
