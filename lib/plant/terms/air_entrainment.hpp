#pragma once

#include "core/portable_math.hpp"
#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Free air in the oil, compressed along p V^n, n = 1.4: 1/beta(p) = 1/beta + r p0^(1/n) / (n p^(1 + 1/n)), Merritt
/// (1967), 1-4, with the volume of Watton (2009), 2.3. The pressure p is taken no lower than p0 = 1 bar. Neutral at 0.
template <class T>
class AirEntrainment {
 public:
  static constexpr std::array kParameters{Parameter{"air_fraction",
                                                    "air_fraction",
                                                    "1",
                                                    "1",
                                                    Scale::kOne,
                                                    false,
                                                    0.0,
                                                    0.3,
                                                    {0.005, 0.04},
                                                    "Share of free air in the volume at 1 bar, r."}};
  static constexpr EffectInfo kInfo{"air_entrainment",
                                    Side::kValveAndOil,
                                    false,
                                    false,
                                    kParameters,
                                    "Free air makes the oil softer, the more the lower its pressure."};

  AirEntrainment(const T* fitted, const Scales&, double) noexcept : fraction_(fitted[0]) {}

  void on_oil(OilMoment<T>& now) noexcept {
    now.softness_a += softness(now.pressure_a_Pa);
    now.softness_b += softness(now.pressure_b_Pa);
  }

 private:
  T softness(const T& pressure_Pa) const noexcept {
    using portable::pow;
    constexpr double kAtmosphere_Pa = 1e5;
    constexpr double kExponent = 1.4;
    const T ratio = pressure_Pa > kAtmosphere_Pa ? T(kAtmosphere_Pa / pressure_Pa) : T(1.0);
    return fraction_ / (kExponent * kAtmosphere_Pa) * pow(ratio, 1.0 + 1.0 / kExponent);
  }

  T fraction_;
};

}  // namespace farrier::plant
