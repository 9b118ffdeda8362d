#pragma once

#include <array>
#include <cstddef>

#include "control/law/low_pass.hpp"
#include "core/ensure.hpp"

namespace farrier::control {

/// Way of a quantity from the joint to the controller, in ticks: y[k] = sum b_i u[k-i] - sum a_i y[k-i]. Passes
/// everything by default.
struct MeasurementFilter {
  static constexpr int kMaxOrder = 10;
  using Polynomial = std::array<double, kMaxOrder + 1>;  ///< in z^-1, beyond `order` zero

  int order = 0;
  Polynomial b{1.0};
  Polynomial a{1.0};  ///< a[0] = 1

  /// True if it passes everything.
  bool is_wire() const noexcept { return order == 0 && b[0] == 1.0; }
};

/// A low-pass as LowPass runs it.
inline MeasurementFilter measurement_filter(const FilterCoefficients& f) noexcept {
  const bool second = f.b[2] != 0.0 || f.a[1] != 0.0;
  const bool first = f.b[1] != 0.0 || f.a[0] != 0.0;
  return {second ? 2 : (first ? 1 : 0), {f.b[0], f.b[1], f.b[2]}, {1.0, f.a[0], f.a[1]}};
}

/// Mean over a tick of `conversions` (>= 1) of a quantity, each through a low-pass at their rate; the last is at the
/// tick. The quantity is taken to be linear between ticks, which makes margins up to 7 % too small where its joint
/// swings at a quarter of the rate of ticks (`farrier compare filters`). One conversion needs no such assumption.
MeasurementFilter oversampled(const FilterCoefficients& low_pass, int conversions) noexcept;

/// One filter behind the other. Their orders together are at most kMaxOrder (checked invariant).
inline MeasurementFilter in_series(const MeasurementFilter& one, const MeasurementFilter& other) noexcept {
  const auto product = [](const MeasurementFilter::Polynomial& p, const MeasurementFilter::Polynomial& q) {
    MeasurementFilter::Polynomial all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = 0; i + j < all.size(); ++j) {
        all[i + j] += p[i] * q[j];
      }
    }
    return all;
  };
  FARRIER_ENSURE(one.order + other.order <= MeasurementFilter::kMaxOrder, "a chain of filters of order 10 at most");
  return {one.order + other.order, product(one.b, other.b), product(one.a, other.a)};
}

/// A MeasurementFilter at run time, in transposed direct form II, from rest.
class RunningFilter {
 public:
  explicit RunningFilter(const MeasurementFilter& filter) noexcept : filter_(filter) {}

  double take(double value) noexcept {
    const double out = filter_.b[0] * value + state_[0];
    for (std::size_t i = 1; i <= static_cast<std::size_t>(filter_.order); ++i) {
      state_[i - 1] = state_[i] + filter_.b[i] * value - filter_.a[i] * out;
    }
    return out;
  }

 private:
  MeasurementFilter filter_;
  MeasurementFilter::Polynomial state_{};  // the last stays 0
};

struct MeasurementFilters {
  MeasurementFilter position;
  MeasurementFilter velocity;
  MeasurementFilter force;

  /// True if all pass everything.
  bool are_wires() const noexcept { return position.is_wire() && velocity.is_wire() && force.is_wire(); }
};

}  // namespace farrier::control
