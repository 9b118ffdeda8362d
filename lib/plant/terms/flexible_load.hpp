#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Part of the load's mass, m_b = s m_l, hangs on the rest by a spring and a damper: a second mass, a loose mount. Its way
/// beside the load is r, its own speed u. Den Hartog (1956), 3.2, has
///
///   r' = u - v,   u' = -w^2 r - 2 D w (u - v),   (1 - s) m_l v' = F - d_l v - C (x - x_eq) - m_b u'.
///
/// A step is the midpoint rule, as that of the load: together they never gain energy. The mean speeds u and v over it,
/// with g = w^2 h / 2 + 2 D w, obey
///
///   u = (2 u_0 / h - w^2 r_0 + g v) / (2 / h + g).
///
/// The load is held back by m_b (2 / h) (g (v - u_0) - w^2 r_0) / (2 / h + g). The part begins at rest beside it.
/// Neutral at 0.
template <class T>
class FlexibleLoad {
 public:
  static constexpr std::array kParameters{
      Parameter{"share_of_mass",
                "share_of_inertia",
                "1",
                "1",
                Scale::kOne,
                false,
                0.0,
                0.9,
                {0.2, 0.2},
                "Share of the load's mass or inertia that hangs on the rest, s."},
      Parameter{"natural_frequency_rad_s",
                "natural_frequency_rad_s",
                "rad/s",
                "rad/s",
                Scale::kRate,
                false,
                12.0,
                400.0,
                {60.0, 60.0},
                "Natural frequency of this part beside a load that stands still, w."},
      Parameter{"damping", "damping", "1", "1", Scale::kOne, false, 0.0, 1.0, {0.05, 0.05}, "Its damping, D."}};
  static constexpr EffectInfo kInfo{"flexible_load",
                                    Side::kLoad,
                                    false,
                                    false,
                                    kParameters,
                                    "A part of the load's mass hangs on the rest by a spring.",
                                    true};

  FlexibleLoad(const T* fitted, const Scales&, double step_s) noexcept
      : share_(fitted[0]),
        stiffness_(fitted[1] * fitted[1]),
        resistance_(0.5 * step_s * stiffness_ + 2.0 * fitted[2] * fitted[1]),
        inertia_(2.0 / step_s),
        step_s_(step_s) {}

  void on_load(LoadMoment<T>& now) noexcept {
    begin(now.velocity);
    const T part = share_ * now.mass * inertia_ / (inertia_ + resistance_);
    now.mass -= share_ * now.mass;
    now.hold -= part * (stiffness_ * way_ + resistance_ * speed_);
    now.slope += part * resistance_;
  }
  void after_load(const T& mean_velocity) noexcept {
    const T mean = (inertia_ * speed_ - stiffness_ * way_ + resistance_ * mean_velocity) / (inertia_ + resistance_);
    way_ += step_s_ * (mean - mean_velocity);
    speed_ += 2.0 * (mean - speed_);
  }
  void follow_load(const T& mean_velocity) noexcept {
    begin(mean_velocity);
    after_load(mean_velocity);
  }

 private:
  void begin(const T& velocity) noexcept {
    if (!started_) {
      speed_ = velocity;
      started_ = true;
    }
  }

  T share_, stiffness_, resistance_;  ///< per mass of the part
  double inertia_, step_s_;
  bool started_ = false;
  T way_ = T(0.0), speed_ = T(0.0);
};

}  // namespace farrier::plant
