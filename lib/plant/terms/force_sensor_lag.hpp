#pragma once

#include "plant/terms/first_order_lag.hpp"
#include "plant/terms/term.hpp"

namespace farrier::plant {

/// A load cell that reads with a lag of first order. Neutral at 0.
template <class T>
class ForceSensorLag {
 public:
  static constexpr std::array kParameters{
      Parameter{"time_constant_s", "time_constant_s", "s", "s", Scale::kSecond, false, 1e-5, 0.05, {0.0005, 0.004},
                "Time constant."}};
  static constexpr EffectInfo kInfo{"force_sensor_lag", Side::kForceSensor, false, false, kParameters,
                                    "The load cell reads late."};

  ForceSensorLag(const T* fitted, const Scales&, double period_s) noexcept
      : lag_(fitted[0], period_s), time_constant_s_(fitted[0]) {}

  void on_force(ForceMoment<T>& now) noexcept { now.force = lag_.take(now.force); }
  /// Time by which what is read lies behind.
  T lag_s() const noexcept { return time_constant_s_; }

 private:
  FirstOrderLag<T> lag_;
  T time_constant_s_;
};

}  // namespace farrier::plant
