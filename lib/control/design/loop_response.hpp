#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/portable_math.hpp"
#include "control/design/margins.hpp"
#include "control/model/part_of_tick.hpp"
#include "control/model/plant_polynomials.hpp"
#include "control/numerics/complex_math.hpp"

namespace farrier::control {

using Complex = std::complex<double>;

// Without the C library's care for infinities.
inline Complex times(Complex a, Complex b) noexcept {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

inline Complex over(Complex a, Complex b) noexcept {
  const double scale = 1.0 / (b.real() * b.real() + b.imag() * b.imag());
  return {(a.real() * b.real() + a.imag() * b.imag()) * scale, (a.imag() * b.real() - a.real() * b.imag()) * scale};
}

template <std::size_t N>
requires(N >= 2) inline Complex polynomial(const std::array<double, N>& c, Complex z) noexcept {
  Complex sum = c[N - 1] * z + c[N - 2];
  for (std::size_t i = N - 2; i-- > 0;) {
    sum = times(sum, z) + c[i];
  }
  return sum;
}

/// The filter's response where z^-1 is `back`.
inline Complex response(const MeasurementFilter& f, Complex back) noexcept {
  Complex b = f.b[static_cast<std::size_t>(f.order)];
  Complex a = f.a[static_cast<std::size_t>(f.order)];
  for (std::size_t i = static_cast<std::size_t>(f.order); i-- > 0;) {
    b = times(b, back) + f.b[i];
    a = times(a, back) + f.a[i];
  }
  return over(b, a);
}

/// Return ratio of a loop that is broken where the current leaves the controller, in normalised units. The `gains` and
/// `filters` outlive it.
///
///   L(z) = z^-d (sum_i k_i N_i(z) H_i(z) + xi K_I N_F(z) H_F(z) / (z - 1)) / (chi(z) (1 + K_1 z^-1 + K_2 z^-2)).
class Loop {
 public:
  Loop(const DiscreteModel& model, const Gains& gains, int delay_ticks, const MeasurementFilters& filters) noexcept
      : model_(normalise(model, gains.normalisation)),
        plant_(plant_polynomials(model_, gains.form)),
        read_(reads(plant_, gains)),
        filters_(filters),
        wires_(filters.are_wires()),
        gains_(gains),
        delay_ticks_(delay_ticks),
        integral_(gains.integral_factor * gains.integral),
        wired_numerator_(multiplied_out(plant_, read_, integral_)) {}

  /// True if every filter is a pass-through.
  bool is_wired() const noexcept { return wires_; }

  /// `z` on the unit circle.
  Complex at(Complex z) const noexcept {
    return over(wires_ ? polynomial(wired_numerator_, z) : numerator(plant_, read_, z), denominator(z));
  }

  /// The sampled plant for currents that act during parts of a tick.
  PartOfTick part_of_tick() const noexcept {
    DiscreteModel model = model_;
    if (gains_.form == Form::kCompliant) {
      model.a.row(0).setZero();
      model.a.col(0).setZero();
      model.b(0) = 0.0;
    }
    return PartOfTick(model);
  }

  /// This loop with its current `ticks` later than it is, held between ticks. The loop outlives it.
  class Delayed {
   public:
    Delayed(const Loop& loop, const PartOfTick& part, double ticks) noexcept : loop_(loop), whole_(std::floor(ticks)) {
      const Eigen::Vector3d soon = part.input(1.0 - (ticks - whole_));
      early_ = plant_polynomials({loop.model_.a, soon}, loop.gains_.form);
      late_ = plant_polynomials({loop.model_.a, loop.model_.b - soon}, loop.gains_.form);
      read_early_ = reads(early_, loop.gains_);
      read_late_ = reads(late_, loop.gains_);
    }

    /// As Loop::at().
    Complex at(Complex z) const noexcept {
      const Complex back = std::conj(z);
      Complex sum = loop_.numerator(early_, read_early_, z) + times(back, loop_.numerator(late_, read_late_, z));
      for (int i = 0; i < static_cast<int>(whole_); ++i) {
        sum = times(sum, back);
      }
      return over(sum, loop_.denominator(z));
    }

   private:
    const Loop& loop_;
    double whole_;
    PlantPolynomials early_, late_;  // of what the current does in the tick it comes in, and in the next
    std::array<double, 3> read_early_, read_late_;
  };

 private:
  using Read = std::array<double, 3>;  // k_x N_x + k_v N_v + k_F N_F

  /// numerator() of a loop without filters, as one polynomial.
  static std::array<double, 4> multiplied_out(const PlantPolynomials& plant, const Read& read,
                                              double integral) noexcept {
    const auto& force = plant.force;
    return {integral * force[0] - read[0], integral * force[1] - read[1] + read[0],
            integral * force[2] - read[2] + read[1], read[2]};
  }

  static Read reads(const PlantPolynomials& plant, const Gains& gains) noexcept {
    Read read{};
    for (std::size_t i = 0; i < read.size(); ++i) {
      read[i] = gains.position * plant.position[i] + gains.velocity * plant.velocity[i] + gains.force * plant.force[i];
    }
    return read;
  }
  Complex numerator(const PlantPolynomials& plant, const Read& read, Complex z) const noexcept {
    const Complex back = std::conj(z);
    const Complex truth = polynomial(plant.force, z);
    const Complex force = wires_ ? truth : times(truth, response(filters_.force, back));
    const Complex proportional =
        wires_ ? polynomial(read, z)
               : gains_.position * times(polynomial(plant.position, z), response(filters_.position, back)) +
                     gains_.velocity * times(polynomial(plant.velocity, z), response(filters_.velocity, back)) +
                     gains_.force * force;
    return times(proportional, z - 1.0) + integral_ * force;
  }
  Complex denominator(Complex z) const noexcept {
    const Complex back = std::conj(z);
    Complex product = times(polynomial(plant_.denominator, z), z - 1.0);
    if (gains_.delay_ticks > 0) {
      product = times(product, 1.0 + times(back, gains_.delay[0] + gains_.delay[1] * back));
    }
    for (int i = 0; i < delay_ticks_; ++i) {
      product = times(product, z);
    }
    return product;
  }

  DiscreteModel model_;  // normalised
  PlantPolynomials plant_;
  Read read_;
  const MeasurementFilters& filters_;
  bool wires_;
  const Gains& gains_;
  int delay_ticks_;
  double integral_;
  std::array<double, 4> wired_numerator_;
};

/// An angle per tick and its place on the unit circle.
struct Angle {
  double value;
  Complex z;
};

inline constexpr double kFirstAngle = 1e-3;

/// Angles evenly in their logarithm, from the first to pi.
template <int Count>
const std::array<Angle, Count>& grid() noexcept {
  static const std::array<Angle, Count> angles = [] {
    std::array<Angle, Count> of;
    for (int i = 0; i < Count; ++i) {
      const double angle =
          kFirstAngle * portable::pow(std::numbers::pi / kFirstAngle, i / static_cast<double>(Count - 1));
      of[static_cast<std::size_t>(i)] = {angle, unit_circle(angle)};
    }
    return of;
  }();
  return angles;
}

/// Grids for loops without filters, and behind filters, whose poles are not among those of the loop.
inline constexpr int kGrid = 32;
inline constexpr int kFineGrid = 160;

}  // namespace farrier::control
