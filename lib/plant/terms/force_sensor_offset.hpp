#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// A load cell that reads a constant beside the force. Neutral at 0.
template <class T>
class ForceSensorOffset {
 public:
  static constexpr std::array kParameters{
      Parameter{"offset_N", "offset_Nm", "N", "Nm", Scale::kForce, false, -1.0, 1.0, {0.01, 0.01}, "What it adds."}};
  static constexpr EffectInfo kInfo{"force_sensor_offset", Side::kForceSensor, false, true, kParameters,
                                    "The load cell reads a constant beside the force."};

  ForceSensorOffset(const T* fitted, const Scales& scales, double) noexcept
      : offset_(fitted[0] * scales.of(Scale::kForce)) {}

  void on_force(ForceMoment<T>& now) noexcept { now.force += offset_; }
  T offset() const noexcept { return offset_; }

 private:
  T offset_;
};

}  // namespace farrier::plant
