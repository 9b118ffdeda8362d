#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "plant/terms/terms.hpp"

namespace farrier::diagnosis {

/// Samples begin to end - 1 of a recording.
struct Span {
  std::size_t begin, end;
  std::size_t size() const noexcept { return end - begin; }
};

/// Signals whose residuals are formed.
enum class Channel { kForce, kMotion, kVelocitySensor };
inline constexpr std::size_t kChannels = 3;

/// Channels that a fit uses.
using ChannelMask = std::array<bool, kChannels>;

/// Channels on which an effect on that side shows.
ChannelMask channels_of(plant::Side side) noexcept;
inline ChannelMask channels_of(plant::EffectId effect) noexcept { return channels_of(plant::effect_info(effect).side); }
/// True if two masks have a channel in common.
bool meet(const ChannelMask& a, const ChannelMask& b) noexcept;
/// The channels of either mask.
ChannelMask either_of(ChannelMask a, const ChannelMask& b) noexcept;
/// The channels of both masks.
ChannelMask both_of(const ChannelMask& a, const ChannelMask& b) noexcept;

/// Numbers of an effect's parameters from which its fits begin, as the library has them; equal ones once.
std::vector<std::vector<double>> starts_of(const plant::EffectInfo& info);

/// Time constants with which a simulation's state is drawn towards the measurement. Infinite: it runs freely.
struct Observer {
  double oil_s = 0.05;
  double load_s = 0.1;
};

/// Nominal constants of a joint that a fit may move within kNominalBand, each a factor; the first eight are left of the
/// load cell.
enum class Nominal {
  kAreaA,
  kAreaB,
  kLineVolume,
  kBulkModulus,
  kValveGain,
  kSupply,
  kPistonMass,
  kPistonDamping,
  kMass,
  kDamping,
  kStiffness
};
inline constexpr std::size_t kNominals = 11;
inline constexpr double kNominalBand = 0.03;

/// A model: factors of the nominal constants and the effects that it has.
struct Model {
  std::array<double, kNominals> factors;
  struct Effect {
    plant::EffectId id;
    std::vector<double> fitted;  ///< numbers of its parameters
  };
  std::vector<Effect> effects;

  static Model nominal() {
    Model model;
    model.factors.fill(1.0);
    return model;
  }
  bool has(plant::EffectId id) const noexcept;
};

/// The number of a model at that place: below kNominals a factor, from there on the numbers of the effects in their order.
double& number_at(Model& model, std::size_t place);

/// Numbers of a model's effects, as a simulation has them.
template <class T>
using EffectNumbers = std::vector<std::pair<plant::EffectId, std::vector<T>>>;
EffectNumbers<double> effect_numbers(const Model& model);

}  // namespace farrier::diagnosis
