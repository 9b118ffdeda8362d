#include "control/margins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "control/closed_loop.hpp"
#include "control/plant_polynomials.hpp"

namespace farrier::control {
namespace {

using Complex = std::complex<double>;

constexpr int kGrid = 48;
constexpr double kFirstAngle = 1e-3;
constexpr int kRefinements = 14;  // golden section: a bracket of two grid steps to a thousandth
constexpr int kBisections = 16;
constexpr double kWorthRefining = 0.5;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Without the C library's care for infinities.
inline Complex times(Complex a, Complex b) noexcept {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

inline Complex over(Complex a, Complex b) noexcept {
  const double scale = 1.0 / (b.real() * b.real() + b.imag() * b.imag());
  return {(a.real() * b.real() + a.imag() * b.imag()) * scale, (a.imag() * b.real() - a.real() * b.imag()) * scale};
}

template <std::size_t N>
inline Complex polynomial(const std::array<double, N>& c, Complex z) noexcept {
  Complex sum = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) {
    sum = times(sum, z) + c[i];
  }
  return sum;
}

/// A filter as n(z) / d(z), of degree two; a straight wire costs nothing.
struct FilterRatio {
  explicit FilterRatio(const MeasurementFilter& f) noexcept : wire(f.c.isZero(0.0) && f.d == 1.0) {
    const double trace = f.a.trace();
    const double determinant = f.a(0, 0) * f.a(1, 1) - f.a(0, 1) * f.a(1, 0);
    const double cb = f.c.dot(f.b);
    denominator = {determinant, -trace, 1.0};
    numerator = {f.d * determinant + (f.c * f.a).dot(f.b) - trace * cb, cb - f.d * trace, f.d};
  }
  Complex at(Complex z) const noexcept { return over(polynomial(numerator, z), polynomial(denominator, z)); }

  bool wire;
  std::array<double, 3> numerator, denominator;
};

/// L(z) = z^-d (sum_i k_i N_i(z) H_i(z) + xi K_I N_F(z) H_F(z) / (z - 1)) / (chi(z) (1 + K_1 z^-1 + K_2 z^-2)).
class Loop {
 public:
  Loop(const DiscreteModel& model, const Gains& gains, int delay_ticks, const MeasurementFilters& filters) noexcept
      : plant_(plant_polynomials(normalise(model, gains.normalisation), gains.form)),
        position_(filters.position),
        velocity_(filters.velocity),
        force_(filters.force),
        gains_(gains),
        delay_ticks_(delay_ticks),
        integral_(gains.integral_factor * gains.integral) {
    for (std::size_t i = 0; i < 3; ++i) {
      proportional_[i] =
          gains.position * plant_.position[i] + gains.velocity * plant_.velocity[i] + gains.force * plant_.force[i];
    }
    wires_ = position_.wire && velocity_.wire && force_.wire;
  }

  Complex at(double angle) const noexcept {
    const Complex z(std::cos(angle), std::sin(angle));
    const Complex back = std::conj(z);
    const Complex force = times(polynomial(plant_.force, z), wires_ ? Complex(1.0) : force_.at(z));
    Complex numerator = wires_ ? polynomial(proportional_, z)
                               : gains_.position * times(polynomial(plant_.position, z), position_.at(z)) +
                                     gains_.velocity * times(polynomial(plant_.velocity, z), velocity_.at(z)) +
                                     gains_.force * force;
    numerator = times(numerator, z - 1.0) + integral_ * force;
    Complex denominator = times(polynomial(plant_.denominator, z), z - 1.0);
    if (gains_.delay_ticks > 0) {
      denominator = times(denominator, 1.0 + gains_.delay[0] * back + gains_.delay[1] * times(back, back));
    }
    for (int i = 0; i < delay_ticks_; ++i) {
      denominator = times(denominator, z);
    }
    return over(numerator, denominator);
  }

 private:
  PlantPolynomials plant_;
  FilterRatio position_, velocity_, force_;
  const Gains& gains_;
  int delay_ticks_;
  double integral_;
  std::array<double, 3> proportional_{};
  bool wires_;
};

struct Point {
  double angle;
  Complex l;
  double closeness;  // |(S - T) / 2|, S - T = (1 - L) / (1 + L)
};

Point look(const Loop& loop, double angle) noexcept {
  const Complex l = loop.at(angle);
  return {angle, l, 0.5 * std::sqrt(std::norm(1.0 - l) / std::norm(1.0 + l))};
}

/// Angle between a and b where f changes sign.
template <class F>
Point crossing(const Loop& loop, Point a, Point b, const F& f) noexcept {
  double f_a = f(a);
  Point middle = a;
  for (int i = 0; i < kBisections; ++i) {
    middle = look(loop, 0.5 * (a.angle + b.angle));
    const double f_m = f(middle);
    if ((f_m < 0.0) == (f_a < 0.0)) {
      a = middle;
      f_a = f_m;
    } else {
      b = middle;
    }
  }
  return middle;
}

/// Largest closeness between a and c by golden section (Kiefer 1953).
Point nearest(const Loop& loop, double a, double c, Point best) noexcept {
  constexpr double kGolden = 0.3819660112501051;
  for (int i = 0; i < kRefinements; ++i) {
    const bool right = c - best.angle > best.angle - a;
    const double step = right ? kGolden * (c - best.angle) : -kGolden * (best.angle - a);
    const Point trial = look(loop, best.angle + step);
    if (trial.closeness > best.closeness) {
      (right ? a : c) = best.angle;
      best = trial;
    } else {
      (right ? c : a) = trial.angle;
    }
  }
  return best;
}

void note_gain(double factor, Margins& m) noexcept {
  if (factor > 1.0) {
    m.gain_up = std::min(m.gain_up, factor);
  } else {
    m.gain_down = std::max(m.gain_down, factor);
  }
}

/// Margins at what happens between neighbouring points.
void note_crossings(const Loop& loop, const Point& a, const Point& b, Margins& m) noexcept {
  const auto imaginary = [](const Point& p) { return p.l.imag(); };
  const auto size = [](const Point& p) { return std::norm(p.l) - 1.0; };
  if ((imaginary(a) < 0.0) != (imaginary(b) < 0.0) && (a.l.real() < 0.0 || b.l.real() < 0.0)) {
    const Point p = crossing(loop, a, b, imaginary);
    if (p.l.real() < 0.0) {
      note_gain(-1.0 / p.l.real(), m);
    }
  }
  if ((size(a) < 0.0) != (size(b) < 0.0)) {
    const Point p = crossing(loop, a, b, size);
    const double lag = std::arg(-p.l);  // of -L from one: what a lag has to take away
    m.phase_rad = std::min(m.phase_rad, std::abs(lag));
    const double turn = lag > 0.0 ? lag : lag + 2.0 * std::numbers::pi;
    m.delay_ticks = std::min(m.delay_ticks, turn / p.angle);
  }
}

/// The closed loop with filters: states of closed_loop_matrix(), then two of each filter.
constexpr int kMaxFilteredStates = kMaxStates + 6;
using FilteredMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxFilteredStates, kMaxFilteredStates>;

/// Whether powers of `m` vanish: squares it until its norm is small or large. A radius within 1e-6 of one is neither,
/// and counts as unstable.
bool vanishes(FilteredMatrix m) noexcept {
  constexpr int kSquarings = 24;
  for (int i = 0; i < kSquarings; ++i) {
    const double norm = m.norm();
    if (!(norm > 1e-2 && norm < 1e50)) {
      return norm <= 1e-2;
    }
    m = (m * m).eval();
  }
  return false;
}

bool filtered_loop_is_stable(const DiscreteModel& model, const Gains& gains, int delay_ticks,
                             const MeasurementFilters& filters) noexcept {
  const SmallMatrix loop = closed_loop_matrix(model, gains, delay_ticks);
  const int states = static_cast<int>(loop.rows());
  const int plant = gains.form == Form::kFullState ? 3 : 2;
  Gains silent = gains;
  silent.position = silent.velocity = silent.force = 0.0;
  SmallMatrix own = closed_loop_matrix(model, silent, delay_ticks);
  own(0, plant) = 0.0;  // what is left reads no measurement; the sum reads the force
  FilteredMatrix whole = FilteredMatrix::Zero(states + 2 * plant, states + 2 * plant);
  whole.topLeftCorner(states, states) = own;
  for (int i = 0; i < plant; ++i) {
    const int channel = i + 3 - plant;
    const MeasurementFilter& f = channel == 0 ? filters.position : (channel == 1 ? filters.velocity : filters.force);
    const SmallColumn read = loop.col(1 + i) - own.col(1 + i);
    whole.block(0, 1 + i, states, 1) += read * f.d;
    whole.block(0, states + 2 * i, states, 2) += read * f.c;
    whole.block<2, 2>(states + 2 * i, states + 2 * i) = f.a;
    whole.block<2, 1>(states + 2 * i, 1 + i) = f.b;
  }
  return whole.allFinite() && vanishes(whole);
}

/// Angles to look at, ascending: the grid and those of the loop's poles.
struct Angles {
  std::array<double, kGrid + kMaxStates> value;
  std::size_t count = 0;
};

Angles angles_for(const SmallSpectrum& poles) noexcept {
  static const std::array<double, kGrid> grid = [] {
    std::array<double, kGrid> angles;
    for (int i = 0; i < kGrid; ++i) {
      angles[static_cast<std::size_t>(i)] =
          kFirstAngle * std::pow(std::numbers::pi / kFirstAngle, i / static_cast<double>(kGrid - 1));
    }
    return angles;
  }();
  Angles angles;
  for (const double angle : grid) {
    angles.value[angles.count++] = angle;
  }
  for (const Complex& pole : poles) {
    const double angle = std::arg(pole);
    if (angle > kFirstAngle && angle < std::numbers::pi) {
      angles.value[angles.count++] = angle;
    }
  }
  std::sort(angles.value.begin(), angles.value.begin() + static_cast<std::ptrdiff_t>(angles.count));
  return angles;
}

bool is_wire(const MeasurementFilters& f) noexcept {
  return FilterRatio(f.position).wire && FilterRatio(f.velocity).wire && FilterRatio(f.force).wire;
}

}  // namespace

Complex loop_gain(const DiscreteModel& model, const Gains& gains, int delay_ticks, const MeasurementFilters& filters,
                  double angle_rad) noexcept {
  return Loop(model, gains, delay_ticks, filters).at(angle_rad);
}

Margins margins(const DiscreteModel& model, const Gains& gains, int delay_ticks,
                const MeasurementFilters& filters) noexcept {
  const SmallSpectrum poles = eigenvalues(closed_loop_matrix(model, gains, delay_ticks));
  const bool stable = is_wire(filters) ? poles.cwiseAbs().maxCoeff() < 1.0
                                       : filtered_loop_is_stable(model, gains, delay_ticks, filters);
  if (!stable || !poles.allFinite()) {
    return {};
  }
  const Loop loop(model, gains, delay_ticks, filters);
  const Angles angles = angles_for(poles);
  std::array<Point, kGrid + kMaxStates> points;
  for (std::size_t i = 0; i < angles.count; ++i) {
    points[i] = look(loop, angles.value[i]);
  }
  Margins m{.disk = 0.0,
            .disk_angle_rad = 0.0,
            .gain_up = kInfinity,
            .gain_down = 0.0,
            .phase_rad = std::numbers::pi,
            .delay_ticks = kInfinity};
  const std::size_t last = angles.count - 1;
  Point worst = points[0].closeness > points[last].closeness ? points[0] : points[last];
  for (std::size_t i = 1; i <= last; ++i) {
    note_crossings(loop, points[i - 1], points[i], m);
    const bool peak = i < last && points[i].closeness >= points[i - 1].closeness &&
                      points[i].closeness >= points[i + 1].closeness;
    // A peak that is far below the worst so far does not become it between two points of the grid.
    if (peak && points[i].closeness > kWorthRefining * worst.closeness) {
      const Point refined = nearest(loop, points[i - 1].angle, points[i + 1].angle, points[i]);
      worst = refined.closeness > worst.closeness ? refined : worst;
    }
  }
  if (points[last].l.real() < 0.0) {  // at half the sampling rate the loop is real
    note_gain(-1.0 / points[last].l.real(), m);
  } else if (points[last].l.real() > 1.0) {
    m.delay_ticks = std::min(m.delay_ticks, 1.0);  // one tick more turns it about, beyond -1
  }
  m.disk = 1.0 / worst.closeness;
  m.disk_angle_rad = worst.angle;
  return m;
}

}  // namespace farrier::control
