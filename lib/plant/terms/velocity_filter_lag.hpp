#pragma once

#include "plant/terms/first_order_lag.hpp"
#include "plant/terms/term.hpp"

namespace farrier::plant {

/// A velocity that is read with a lag of first order. Neutral at 0.
template <class T>
class VelocityFilterLag {
 public:
  static constexpr std::array kParameters{
      Parameter{"time_constant_s", "time_constant_s", "s", "s", Scale::kSecond, false, 1e-5, 0.05, {0.0005, 0.004},
                "Time constant."}};
  static constexpr EffectInfo kInfo{"velocity_filter_lag", Side::kVelocitySensor, false, false, kParameters,
                                    "The velocity is read late."};

  VelocityFilterLag(const T* fitted, const Scales&, double period_s) noexcept : lag_(fitted[0], period_s) {}

  T on_velocity(const T& velocity) noexcept { return lag_.take(velocity); }

 private:
  FirstOrderLag<T> lag_;
};

}  // namespace farrier::plant
