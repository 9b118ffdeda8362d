#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// A load cell that reads g times the force. Neutral at 1.
template <class T>
class ForceSensorGain {
 public:
  static constexpr std::array kParameters{
      Parameter{"gain", "gain", "1", "1", Scale::kOne, false, 0.1, 5.0, {1.05, 1.05}, "Gain, g."}};
  static constexpr EffectInfo kInfo{"force_sensor_gain", Side::kForceSensor, true, true, kParameters,
                                    "The load cell reads a multiple of the force."};

  ForceSensorGain(const T* fitted, const Scales&, double) noexcept : gain_(fitted[0]) {}

  void on_force(ForceMoment<T>& now) noexcept { now.force *= gain_; }
  T gain() const noexcept { return gain_; }

 private:
  T gain_;
};

}  // namespace farrier::plant
