#include "control/design/delay_margin.hpp"

#include <limits>
#include <optional>

#include "control/numerics/complex_math.hpp"

namespace farrier::control {
namespace {

/// A crossing of |L| = 1 with a delay, and the pure delay that is left there until L = -1.
struct DelayedCrossing {
  double angle;
  double left_ticks;
};

/// The crossing near `angle` of the loop with a held current `delay` ticks later; none where it is lost.
std::optional<DelayedCrossing> delayed_crossing(const Loop& loop, const PartOfTick& part, double angle,
                                                double delay) noexcept {
  constexpr int kSecants = 10;
  constexpr double kStep = 1e-3;
  constexpr double kEnough = 1e-7;  // of log |L|^2
  const Loop::Delayed delayed(loop, part, delay);
  const auto log_size = [&](double at, Complex& l) {
    l = delayed.at(unit_circle(at));
    return portable::log(std::norm(l));
  };
  Complex l;
  double before = angle * (1.0 - kStep);
  double size_before = log_size(before, l);
  for (int i = 0; i < kSecants; ++i) {
    const double size = log_size(angle, l);
    if (std::abs(size) < kEnough) {
      return DelayedCrossing{angle, angle_of(-l) / angle};
    }
    const double slope = (size - size_before) / (angle - before);
    before = angle;
    size_before = size;
    angle -= size / slope;
    if (!(angle > 0.5 * before && angle < std::min(2.0 * before, std::numbers::pi))) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

/// Turn of 1 + L about 0 between two angles, where it is `from` and `to`; halved until each part turns little.
template <class OneAndL>
double turn(const OneAndL& one_and_l, double from_angle, Complex from, double to_angle, Complex to,
            int halvings) noexcept {
  constexpr double kLittle = 0.5;
  const double whole = angle_of(times(to, std::conj(from)));
  if (std::abs(whole) < kLittle || halvings == 0) {
    return whole;
  }
  const double middle = 0.5 * (from_angle + to_angle);
  const Complex there = one_and_l(middle);
  return turn(one_and_l, from_angle, from, middle, there, halvings - 1) +
         turn(one_and_l, middle, there, to_angle, to, halvings - 1);
}

/// The same over the grid, with the current `delay` ticks later. As many encirclements as of a stable loop's mean a
/// stable loop (Nyquist).
double whole_turn(const Loop& loop, const PartOfTick& part, double delay) noexcept {
  constexpr int kHalvings = 8;
  const Loop::Delayed delayed(loop, part, delay);
  const auto one_and_l = [&](double angle) { return 1.0 + delayed.at(unit_circle(angle)); };
  const auto& angles = grid<kFineGrid>();
  double sum = 0.0;
  Complex before = 1.0 + delayed.at(angles[0].z);
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const Complex now = 1.0 + delayed.at(angles[i].z);
    sum += turn(one_and_l, angles[i - 1].value, before, angles[i].value, now, kHalvings);
    before = now;
  }
  return sum;
}

}  // namespace

double held_delay(const Loop& loop, double angle, double ticks) noexcept {
  constexpr int kRounds = 10;
  constexpr double kEnough = 1e-3;  // of a tick, and of the delay
  const PartOfTick part = loop.part_of_tick();
  double stable = std::floor(ticks);
  double unstable = std::ceil(ticks);
  double delay = ticks;
  for (int i = 0; i < kRounds && unstable - stable > kEnough * (1.0 + ticks); ++i) {
    const auto crossing = delayed_crossing(loop, part, angle, delay);
    if (crossing && crossing->left_ticks <= 0.0) {
      unstable = delay;
      angle = crossing->angle;
    } else {
      stable = delay;
    }
    const double guess = crossing ? delay + crossing->left_ticks : 0.0;
    if (crossing && std::abs(crossing->left_ticks) < kEnough * (1.0 + delay)) {
      return delay;
    }
    delay = guess > stable && guess < unstable ? guess : 0.5 * (stable + unstable);
  }
  return unstable;
}

double turning_delay(const Loop& loop) noexcept {
  constexpr int kLooks = 8;
  constexpr int kHalvings = 10;
  const PartOfTick part = loop.part_of_tick();
  const auto beyond = [&](double delay) { return Loop::Delayed(loop, part, delay).at({-1.0, 0.0}).real() < -1.0; };
  for (int i = 1; i <= kLooks; ++i) {
    double outside = static_cast<double>(i) / kLooks;
    if (!beyond(outside)) {
      continue;
    }
    double inside = static_cast<double>(i - 1) / kLooks;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = 0.5 * (inside + outside);
      (beyond(middle) ? outside : inside) = middle;
    }
    return outside;
  }
  return std::numeric_limits<double>::infinity();
}

double delay_behind_filters(const Loop& loop, double estimate) noexcept {
  constexpr std::array kShares{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.88, 0.96, 1.02, 1.1, 1.2, 1.35, 1.5, 2.0};
  constexpr int kHalvings = 6;
  constexpr double kHalfTurn = 0.5 * std::numbers::pi;
  constexpr double kFewTicks = 8.0;
  constexpr double kLastBeyond = 4.0;  // an estimate above this is not taken for too small
  if (!(estimate < kFewTicks)) {
    return estimate;
  }
  const PartOfTick part = loop.part_of_tick();
  const double stable_turn = whole_turn(loop, part, 0.0);
  const auto is_stable = [&](double delay) {
    return std::abs(whole_turn(loop, part, delay) - stable_turn) < kHalfTurn;
  };
  double stable = 0.0;
  for (const double share : kShares) {
    if (share > 1.0 && estimate > kLastBeyond) {
      break;
    }
    double unstable = share * estimate;
    if (is_stable(unstable)) {
      stable = unstable;
      continue;
    }
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (stable + unstable);
      (is_stable(middle) ? stable : unstable) = middle;
    }
    return unstable;
  }
  return estimate;
}

}  // namespace farrier::control
