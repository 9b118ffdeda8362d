#include "control/design/margins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "control/design/closed_loop.hpp"
#include "control/design/filtered_loop.hpp"
#include "control/model/plant_polynomials.hpp"

namespace farrier::control {
namespace {

using Complex = std::complex<double>;

constexpr int kGrid = 32;
constexpr double kFirstAngle = 1e-3;
constexpr int kRefinements = 6;      // parabolas through three points of a smooth peak
constexpr int kCrossingSteps = 12;
constexpr double kAngleShare = 1e-6;  // of an angle: a crossing is known well enough
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

/// A filter as n(z) / d(z), of degree two; a pass-through costs nothing.
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

  /// True if every filter is a pass-through.
  bool is_wired() const noexcept { return wires_; }

  /// `z` on the unit circle.
  Complex at(Complex z) const noexcept {
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

Point look(const Loop& loop, double angle, Complex z) noexcept {
  const Complex l = loop.at(z);
  return {angle, l, 0.5 * std::sqrt(std::norm(1.0 - l) / std::norm(1.0 + l))};
}

Point look(const Loop& loop, double angle) noexcept { return look(loop, angle, {std::cos(angle), std::sin(angle)}); }

/// Angle between a and b where f changes sign, by false position with halved weights (Dowell and Jarratt 1971,
/// "Illinois").
template <class F>
Point crossing(const Loop& loop, Point a, Point b, const F& f) noexcept {
  double f_a = f(a);
  double f_b = f(b);
  Point middle = a;
  for (int i = 0; i < kCrossingSteps && b.angle - a.angle > kAngleShare * b.angle; ++i) {
    const double share = f_a / (f_a - f_b);
    const double before = middle.angle;
    middle = look(loop, a.angle + share * (b.angle - a.angle));
    const double f_m = f(middle);
    if ((f_m < 0.0) == (f_a < 0.0)) {
      f_b *= a.angle == before ? 0.5 : 1.0;
      a = middle;
      f_a = f_m;
    } else {
      f_a *= b.angle == before ? 0.5 : 1.0;
      b = middle;
      f_b = f_m;
    }
    if (std::abs(middle.angle - before) <= kAngleShare * middle.angle) {
      break;
    }
  }
  return middle;
}

/// Largest closeness between a and c, of which b is nearer than either: tops of the parabola through the three.
Point nearest(const Loop& loop, Point a, Point b, Point c) noexcept {
  for (int i = 0; i < kRefinements; ++i) {
    const double left = (b.angle - a.angle) * (b.closeness - c.closeness);
    const double right = (c.angle - b.angle) * (b.closeness - a.closeness);
    const double top = b.angle + 0.5 * ((c.angle - b.angle) * right - (b.angle - a.angle) * left) / (left + right);
    // The three in a line, or the top where b is: half the longer side instead.
    const bool inside = top > a.angle && top < c.angle && std::abs(top - b.angle) > kAngleShare * b.angle;
    const double aim = inside ? top
                       : c.angle - b.angle > b.angle - a.angle ? 0.5 * (b.angle + c.angle)
                                                               : 0.5 * (a.angle + b.angle);
    const Point trial = look(loop, aim);
    const bool beyond = trial.angle > b.angle;
    if (trial.closeness > b.closeness) {
      (beyond ? a : c) = b;
      b = trial;
    } else {
      (beyond ? c : a) = trial;
    }
  }
  return b;
}

void note_gain(double factor, Margins& m) noexcept {
  if (factor > 1.0) {
    m.gain_up = std::min(m.gain_up, factor);
  } else {
    m.gain_down = std::max(m.gain_down, factor);
  }
}

/// Updates the margins with the crossings between neighbouring points.
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
    const double lag = std::arg(-p.l);  // angle of -L: the lag that moves L to -1
    m.phase_rad = std::min(m.phase_rad, std::abs(lag));
    const double turn = lag > 0.0 ? lag : lag + 2.0 * std::numbers::pi;
    m.delay_ticks = std::min(m.delay_ticks, turn / p.angle);
  }
}

/// Angles to evaluate, ascending: the grid and the angles of the loop's poles, each with its place on the unit circle.
struct Angle {
  double value;
  Complex z;
};
struct Angles {
  std::array<Angle, kGrid + kMaxStates> of;
  std::size_t count = 0;
};

Angles angles_for(const SmallSpectrum& poles) noexcept {
  static const std::array<Angle, kGrid> grid = [] {
    std::array<Angle, kGrid> angles;
    for (int i = 0; i < kGrid; ++i) {
      const double angle = kFirstAngle * std::pow(std::numbers::pi / kFirstAngle, i / static_cast<double>(kGrid - 1));
      angles[static_cast<std::size_t>(i)] = {angle, std::polar(1.0, angle)};
    }
    return angles;
  }();
  Angles angles;
  for (const Angle& angle : grid) {
    angles.of[angles.count++] = angle;
  }
  for (const Complex& pole : poles) {
    const double angle = std::arg(pole);
    if (angle > kFirstAngle && angle < std::numbers::pi) {
      angles.of[angles.count++] = {angle, pole / std::abs(pole)};
    }
  }
  std::sort(angles.of.begin(), angles.of.begin() + static_cast<std::ptrdiff_t>(angles.count),
            [](const Angle& a, const Angle& b) { return a.value < b.value; });
  return angles;
}

}  // namespace

Complex loop_gain(const DiscreteModel& model, const Gains& gains, int delay_ticks, const MeasurementFilters& filters,
                  double angle_rad) noexcept {
  return Loop(model, gains, delay_ticks, filters).at(std::polar(1.0, angle_rad));
}

Margins margins(const DiscreteModel& model, const Gains& gains, int delay_ticks,
                const MeasurementFilters& filters) noexcept {
  return margins(model, gains, delay_ticks, filters, closed_loop_spectrum(model, gains, delay_ticks));
}

Margins margins(const DiscreteModel& model, const Gains& gains, int delay_ticks, const MeasurementFilters& filters,
                const SmallSpectrum& poles) noexcept {
  const Loop loop(model, gains, delay_ticks, filters);
  const bool stable = loop.is_wired() ? poles.cwiseAbs().maxCoeff() < 1.0
                                      : filtered_loop_is_stable(model, gains, delay_ticks, filters);
  if (!stable || !poles.allFinite()) {
    return {};
  }
  const Angles angles = angles_for(poles);
  std::array<Point, kGrid + kMaxStates> points;
  for (std::size_t i = 0; i < angles.count; ++i) {
    points[i] = look(loop, angles.of[i].value, angles.of[i].z);
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
      const Point refined = nearest(loop, points[i - 1], points[i], points[i + 1]);
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
