#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Time between a current and the valve that has it. Neutral at 0.
template <class T>
class InputDelay {
 public:
  static constexpr std::array kParameters{
      Parameter{"delay_s", "delay_s", "s", "s", Scale::kSecond, false, 0.0, 0.03, {0.0012, 0.005}, "The delay."}};
  static constexpr EffectInfo kInfo{"input_delay", Side::kValveAndOil,
                                    false,         false,
                                    kParameters,   "The valve has a current later than it was commanded.",
                                    true};

  InputDelay(const T* fitted, const Scales&, double) noexcept : delay_s_(fitted[0]) {}

  const T& delay_s() const noexcept { return delay_s_; }

 private:
  T delay_s_;
};

}  // namespace farrier::plant
