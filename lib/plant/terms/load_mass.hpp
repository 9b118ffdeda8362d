#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Another mass behind the load cell, m_l of Hubacher (2014) (2.24). Neutral at the nominal one.
template <class T>
class LoadMass {
 public:
  static constexpr std::array kParameters{
      Parameter{"mass_kg", "inertia_kg_m2", "kg", "kg m^2", Scale::kMass, false, 0.02, 20.0, {1.05, 1.05},
                "Another mass behind the load cell."}};
  static constexpr EffectInfo kInfo{"load_mass", Side::kLoad, true, true, kParameters,
                                    "The load has another mass or inertia than the model."};

  LoadMass(const T* fitted, const Scales& scales, double) noexcept : mass_(fitted[0] * scales.of(Scale::kMass)) {}

  void on_load(LoadMoment<T>& now) noexcept { now.mass = mass_; }

 private:
  T mass_;
};

}  // namespace farrier::plant
