#include "control/design/margins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "control/design/closed_loop.hpp"
#include "control/design/delay_margin.hpp"
#include "control/design/filtered_loop.hpp"
#include "control/design/loop_response.hpp"
#include "control/numerics/complex_math.hpp"

namespace farrier::control {
namespace {

constexpr int kRefinements = 6;  // parabolas through three points of a smooth peak
constexpr int kCrossingSteps = 12;
constexpr double kAngleShare = 1e-4;  // of an angle: a crossing is known well enough
constexpr double kWorthRefining = 0.5;
constexpr double kQuiet = 0.2;     // |L| at half the sampling rate, too small for any delay to matter there
constexpr double kFarDelay = 1.5;  // times the least so far: not the least, however it is held
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Angles to evaluate, ascending: the grid and the angles of the loop's poles.
template <int Grid>
struct Angles {
  std::array<Angle, Grid + kMaxStates> of;
  std::size_t count = Grid;
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

Point look(const Loop& loop, double angle) noexcept { return look(loop, angle, unit_circle(angle)); }

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
    const double aim = inside                                  ? top
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
    const double lag = angle_of(-p.l);  // angle of -L: the lag that moves L to -1
    m.phase_rad = std::min(m.phase_rad, std::abs(lag));
    const double turn = lag > 0.0 ? lag : lag + 2.0 * std::numbers::pi;
    const double pure = turn / p.angle;
    if (loop.is_wired()) {
      m.delay_ticks = std::min(m.delay_ticks, pure);
    } else if (pure < kFarDelay * m.delay_ticks) {
      m.delay_ticks = std::min(m.delay_ticks, held_delay(loop, p.angle, pure));
    }
  }
}

template <int Grid>
Angles<Grid> angles_for(const SmallSpectrum& poles) noexcept {
  Angles<Grid> angles;
  std::ranges::copy(grid<Grid>(), angles.of.begin());
  for (const Complex& pole : poles) {
    const double angle = angle_of(pole);
    if (angle > kFirstAngle && angle < std::numbers::pi) {
      angles.of[angles.count++] = {angle, pole / std::abs(pole)};
    }
  }
  std::sort(angles.of.begin(), angles.of.begin() + static_cast<std::ptrdiff_t>(angles.count),
            [](const Angle& a, const Angle& b) { return a.value < b.value; });
  return angles;
}

/// Margins of a stable loop.
template <int Grid>
Margins margins_on_grid(const Loop& loop, const SmallSpectrum& poles) noexcept {
  const Angles<Grid> angles = angles_for<Grid>(poles);
  std::array<Point, Grid + kMaxStates> points;
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
    const bool peak =
        i < last && points[i].closeness >= points[i - 1].closeness && points[i].closeness >= points[i + 1].closeness;
    // A peak that is far below the worst so far does not become it between two points of the grid.
    if (peak && points[i].closeness > kWorthRefining * worst.closeness) {
      const Point refined = nearest(loop, points[i - 1], points[i], points[i + 1]);
      worst = refined.closeness > worst.closeness ? refined : worst;
    }
  }
  if (points[last].l.real() < 0.0) {  // at half the sampling rate the loop is real
    note_gain(-1.0 / points[last].l.real(), m);
  }
  if (loop.is_wired()) {
    // One tick more turns a loop above 1 about, beyond -1.
    m.delay_ticks = points[last].l.real() > 1.0 ? std::min(m.delay_ticks, 1.0) : m.delay_ticks;
  } else {
    if (std::abs(points[last].l.real()) > kQuiet) {
      m.delay_ticks = std::min(m.delay_ticks, turning_delay(loop));
    }
    m.delay_ticks = delay_behind_filters(loop, m.delay_ticks);
  }
  m.disk = 1.0 / worst.closeness;
  m.disk_angle_rad = worst.angle;
  return m;
}

}  // namespace

Complex loop_gain(const DiscreteModel& model, const Gains& gains, int delay_ticks, const MeasurementFilters& filters,
                  double angle_rad) noexcept {
  return Loop(model, gains, delay_ticks, filters).at(unit_circle(angle_rad));
}

Margins margins(const DiscreteModel& model, const Gains& gains, int delay_ticks,
                const MeasurementFilters& filters) noexcept {
  return margins(model, gains, delay_ticks, filters, closed_loop_spectrum(model, gains, delay_ticks));
}

Margins margins(const DiscreteModel& model, const Gains& gains, int delay_ticks, const MeasurementFilters& filters,
                const SmallSpectrum& poles) noexcept {
  const Loop loop(model, gains, delay_ticks, filters);
  const bool stable =
      loop.is_wired() ? poles.cwiseAbs().maxCoeff() < 1.0 : filtered_loop_is_stable(model, gains, delay_ticks, filters);
  if (!stable || !poles.allFinite()) {
    return {};
  }
  return loop.is_wired() ? margins_on_grid<kGrid>(loop, poles) : margins_on_grid<kFineGrid>(loop, poles);
}

}  // namespace farrier::control