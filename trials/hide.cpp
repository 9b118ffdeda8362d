#include "trials/hide.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "core/noise.hpp"
#include "gait/reference.hpp"
#include "plant/terms/load_effects.hpp"

namespace farrier::trials {
namespace {

using plant::effect_id;
using plant::EffectId;

/// Places of what is drawn in a joint's stream.
enum Drawn : Tick { kJoint, kEffect, kSize, kSign };

/// Size of an effect: its first parameter as a fitted number (plant/terms/term.hpp), beside the neutral one. If that is
/// 1 it is a factor, on it or under it.
struct Size {
  EffectId id;
  double low, high;
};

/// Effect sizes with which HyQ can still trot. Effects not listed begin where the second fit begins (Parameter::starts)
/// and go to twice its distance from the neutral value. A general form has the sizes of its special case.
constexpr std::array kSizes{
    Size{effect_id<plant::InputDelay>(), 0.0003, 0.0009},     Size{effect_id<plant::ValveBias>(), 0.02, 0.06},
    Size{effect_id<plant::ValveDynamics>(), 0.0003, 0.0007},  Size{effect_id<plant::ValveDeadband>(), 0.02, 0.06},
    Size{effect_id<plant::ValveAsymmetry>(), 0.15, 0.35},     Size{effect_id<plant::FlowSaturation>(), 2.0, 5.0},
    Size{effect_id<plant::SupplyDroop>(), 0.3, 1.0},          Size{effect_id<plant::InternalLeakage>(), 0.02, 0.06},
    Size{effect_id<plant::AirEntrainment>(), 0.02, 0.08},     Size{effect_id<plant::Backlash>(), 0.004, 0.012},
    Size{effect_id<plant::PistonFriction>(), 0.02, 0.06},     Size{effect_id<plant::LoadMass>(), 1.5, 3.0},
    Size{effect_id<plant::LoadStiffness>(), 0.2, 0.8},        Size{effect_id<plant::LoadDamping>(), 1.5, 3.0},
    Size{effect_id<plant::SpringHardening>(), 3.0, 12.0},     Size{effect_id<plant::ExternalForce>(), 0.03, 0.08},
    Size{effect_id<plant::LoadFriction>(), 0.02, 0.06},       Size{effect_id<plant::ForceSensorLag>(), 0.0015, 0.004},
    Size{effect_id<plant::ForceSensorGain>(), 1.06, 1.12},    Size{effect_id<plant::ForceSensorOffset>(), 0.03, 0.08},
    Size{effect_id<plant::FlexibleLoad>(), 0.15, 0.3},        Size{effect_id<plant::ValveHysteresis>(), 0.01, 0.03},
    Size{effect_id<plant::VelocityFilterLag>(), 0.002, 0.006}};

/// Distance of an end stop from the ends of its stroke, over the stroke, at which it takes this share of the way off
/// the joint's planned motion. It leaves the joint where it stands at home.
double inset(const robot::Robot& robot, const robot::Joint& joint, double share) {
  constexpr double kRoomAtHome = 0.005;
  constexpr double kMotion_s = 6.0;
  const double stroke = joint.actuator.stroke;
  const gait::Reference reference(robot.plan);
  const double home = joint.linkage.position(joint.home_angle_rad) / stroke;
  double least = home;
  double most = home;
  for (Tick tick = 0; tick < static_cast<Tick>(kMotion_s / robot.period_s); ++tick) {
    const double at = joint.linkage.position(reference.at(joint.leg, joint.index_in_leg, tick).position_rad) / stroke;
    least = std::min(least, at);
    most = std::max(most, at);
  }
  return std::min(std::min(least, 1.0 - most) + share * (most - least), std::min(home, 1.0 - home) - kRoomAtHome);
}

/// Size of an effect that is not listed. A factor on a nominal value `neutral` goes from its start to twice the
/// distance from 1, another size from its start to twice that.
Size default_size(EffectId id, const plant::Parameter& size, double neutral) {
  const double start = size.starts[1];
  return neutral > 0.0 ? Size{id, start / neutral, 2.0 * start / neutral - 1.0} : Size{id, start, 2.0 * start};
}

double fitted_size(const robot::Robot& robot, const robot::Joint& joint, EffectId id, const plant::Scales& scales,
                   const NoiseStream& stream) {
  const plant::EffectInfo& info = plant::effect_info(id);
  const plant::Parameter& size = info.parameters.front();
  const double share = stream.uniform(kSize);
  if (id == effect_id<plant::EndStop>()) {
    return std::clamp(inset(robot, joint, 0.1 + 0.2 * share), size.low, size.high);
  }
  const double neutral = scales.neutral(size);
  const auto listed =
      std::ranges::find(kSizes, plant::is_general_form(id) ? plant::special_case_of(id) : id, &Size::id);
  const Size range = listed != kSizes.end() ? *listed : default_size(id, size, info.nominal ? neutral : 0.0);
  const double drawn = range.low + share * (range.high - range.low);
  const bool below = info.either_sign && stream.uniform(kSign) < 0.5;
  if (info.nominal && neutral > 0.0) {
    return std::clamp(below ? neutral / drawn : neutral * drawn, size.low, size.high);
  }
  return std::clamp(neutral + (below && size.low < 0.0 ? -drawn : drawn), size.low, size.high);
}

}  // namespace

robot::Robot hide_effect(const robot::Robot& nominal, std::size_t place, EffectId id, std::uint64_t seed,
                         HiddenEffect& what) {
  robot::Robot world = nominal;
  robot::Joint& joint = world.joints[place];
  const plant::Scales scales(joint.actuator, joint.swing_load);
  const plant::EffectInfo& info = plant::effect_info(id);
  const plant::Parameter& first = info.parameters.front();
  const NoiseStream stream(seed, joint.name, info.name);

  plant::ActiveEffect effect{id, {}};
  effect.values[0] = scales.value(first, fitted_size(nominal, joint, id, scales, stream));
  for (std::size_t i = 1; i < info.parameters.size(); ++i) {
    effect.values[i] = plant::default_value(info.parameters[i], scales, joint.actuator, joint.swing_load);
  }
  const plant::Loads loads =
      plant::loads_with_effects({joint.swing_load, joint.stance_load}, joint.actuator, std::span(&effect, 1));
  joint.swing_load = loads.swing;
  joint.stance_load = loads.stance;
  joint.effects.push_back(effect);
  what = {joint.name, info.name, joint.rotary ? first.rotary_name : first.name, effect.values[0],
          joint.rotary ? first.rotary_unit : first.unit};
  return world;
}

robot::Robot hide_effect(const robot::Robot& nominal, std::uint64_t seed, HiddenEffect& what) {
  const NoiseStream stream(seed, nominal.name, "hide");
  const auto one_of = [&](Drawn drawn, std::size_t count) {
    return static_cast<std::size_t>(stream.uniform(drawn) * static_cast<double>(count));
  };
  const std::size_t joint = one_of(kJoint, nominal.joints.size());
  std::vector<EffectId> lacking;
  for (EffectId id = 0; id < plant::kEffectCount; ++id) {
    if (plant::find(nominal.joints[joint].effects, id) == nullptr) {
      lacking.push_back(id);
    }
  }
  return hide_effect(nominal, joint, lacking[one_of(kEffect, lacking.size())], seed, what);
}

}  // namespace farrier::trials
