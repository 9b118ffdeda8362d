#pragma once

#include <algorithm>
#include <string_view>

#include "plant/terms/friction_wave.hpp"
#include "plant/terms/load_contact.hpp"

namespace farrier::plant {

/// Place of a parameter of the contact.
constexpr std::size_t find_contact_parameter(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(kContactParameters, name, &Parameter::name) -
                                  kContactParameters.begin());
}

/// Parameters of the contact, whose friction is now the mean over a wave, then those of the wave.
inline constexpr std::array kWavyContactParameters = [] {
  constexpr std::array kWave{Parameter{"waviness",
                                       "waviness",
                                       "1",
                                       "1",
                                       Scale::kOne,
                                       false,
                                       0.25,
                                       0.95,
                                       {0.5, 0.5},
                                       "Swing of the friction about its mean, over that."},
                             Parameter{"wavelength_m",
                                       "wavelength_rad",
                                       "m",
                                       "rad",
                                       Scale::kLength,
                                       false,
                                       0.01,
                                       2.0,
                                       {0.3, 0.3},
                                       "Way over which the friction swings once."},
                             Parameter{"tightest_position_m",
                                       "tightest_position_rad",
                                       "m",
                                       "rad",
                                       Scale::kLength,
                                       false,
                                       -0.5,
                                       1.5,
                                       {0.5, 0.5},
                                       "A position at which the friction is largest."}};
  std::array<Parameter, kContactParameters.size() + kWave.size()> all{};
  std::ranges::copy(kWave, std::ranges::copy(kContactParameters, all.begin()).out);
  // Where the friction is a quarter of its mean the bristles bend as far as those of a level one.
  constexpr double kPresliding = 4.0 * kPreslidingShare;
  all[find_contact_parameter("presliding_m")].starts = {kPresliding, kPresliding};
  return all;
}();

/// LoadFriction whose level swings with the load's position (FrictionWave). Its parameters begin with those of
/// LoadFriction. Neutral at 0.
template <class T>
class PositionDependentFriction {
 public:
  static constexpr std::array kParameters = kWavyContactParameters;
  static constexpr EffectInfo kInfo{"position_dependent_friction",
                                    Side::kLoad,
                                    false,
                                    false,
                                    kParameters,
                                    "The load's guides are tight in some places and loose in others.",
                                    true,
                                    "load_friction"};

  PositionDependentFriction(const T* fitted, const Scales& scales, double step_s) noexcept
      : contact_(fitted, scales, step_s),
        wave_{fitted[kWaviness], fitted[kWaviness + 1] * scales.of(Scale::kLength),
              fitted[kWaviness + 2] * scales.of(Scale::kLength)} {}

  void on_load(LoadMoment<T>& now) noexcept { contact_.on_load(now, wave_.level(now.position)); }
  void after_load(const T& mean_velocity) noexcept { contact_.after_load(mean_velocity); }

 private:
  static constexpr std::size_t kWaviness = kContactParameters.size();

  LoadContact<T> contact_;
  FrictionWave<T> wave_;
};

}  // namespace farrier::plant
