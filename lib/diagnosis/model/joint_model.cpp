#include "diagnosis/model/joint_model.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "diagnosis/model/load_starts.hpp"
#include "diagnosis/model/jets.hpp"
#include "plant/terms/active_effect.hpp"

namespace farrier::diagnosis {

namespace {

/// Natural frequencies of a part of the load on a spring from which fits begin.
constexpr std::array kBranch_Hz{5.0, 8.0, 12.0, 18.0, 28.0};

/// Terms of sensors act once per sample, the others once per substep of the channel's simulation.
double step_of(plant::Side side, const JointData& data, Channel channel) noexcept {
  switch (side) {
    case plant::Side::kValveAndOil:
    case plant::Side::kDrive:
      return channel == Channel::kMotion ? data.load_step_s() : data.step_s();
    case plant::Side::kLoad:
      return data.load_step_s();
    case plant::Side::kForceSensor:
    case plant::Side::kVelocitySensor:
      return data.period_s;
  }
  return data.period_s;
}

}  // namespace

JointModel::JointModel(const plant::ActuatorParams& actuator, const plant::LoadParams& load,
                       std::vector<Model::Effect> known)
    : actuator_(actuator), load_(load), scales_(actuator, load), known_(std::move(known)) {}

const std::vector<double>* JointModel::known(plant::EffectId id) const noexcept {
  const auto found = std::ranges::find(known_, id, &Model::Effect::id);
  return found == known_.end() ? nullptr : &found->fitted;
}

ChannelMask JointModel::channels(plant::EffectId id) const noexcept {
  return id < plant::kEffectCount ? channels_of(id) : ChannelMask{};
}

bool JointModel::bends_force(plant::EffectId id) const noexcept {
  return id == plant::effect_id<plant::InputDelay>() || id == plant::effect_id<plant::ValveDynamics>();
}

ChannelMask JointModel::nominal_channels(std::size_t factor) const noexcept {
  const bool absent = (factor == static_cast<std::size_t>(Nominal::kStiffness) && load_.stiffness == 0.0) ||
                      (factor == static_cast<std::size_t>(Nominal::kPistonMass) && actuator_.piston_mass == 0.0);
  return absent                                              ? ChannelMask{}
         : factor < static_cast<std::size_t>(Nominal::kMass) ? ChannelMask{true, false, false}
                                                             : ChannelMask{false, true, false};
}

bool JointModel::fits(plant::EffectId id, std::size_t parameter) const noexcept {
  return !plant::effect_info(id).parameters[parameter].held;
}

std::vector<std::vector<double>> JointModel::starts(plant::EffectId effect, const JointData& data) const {
  if (effect >= plant::kEffectCount) {
    return {};
  }
  if (const std::vector<double>* known = this->known(effect)) {
    return {*known};
  }
  if (effect == plant::effect_id<plant::PositionDependentFriction>()) {
    return starts_of_friction_wave(data, scales_);
  }
  std::vector<std::vector<double>> all = usual_starts(*this, effect, data);
  if (effect == plant::effect_id<plant::EndStop>()) {
    // A stop is seen where the motion turns: just inside the outermost position.
    const auto [low, high] = std::ranges::minmax(data.position);
    const double length = scales_.of(plant::Scale::kLength);
    all[0][0] = (std::min(low, length - high) + 0.02 * (high - low)) / length;
  }
  if (effect == plant::effect_id<plant::FlexibleLoad>()) {
    // A resonance is found from nearby only.
    all.assign(kBranch_Hz.size(), all[0]);
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i][1] = 2.0 * std::numbers::pi * kBranch_Hz[i];
    }
  }
  return all;
}

template <class T>
Constants<T> JointModel::constants(const std::array<T, kNominals>& f) const {
  const plant::ActuatorParams& a = actuator_;
  return {f[0] * a.area_a,
          f[1] * a.area_b,
          f[2] * a.line_volume_m3,
          f[3] * a.bulk_modulus_Pa,
          f[4] * a.valve_gain,
          f[5] * a.supply_pressure_Pa,
          f[6] * a.piston_mass,
          f[7] * a.piston_damping,
          f[8] * load_.mass,
          f[9] * load_.damping,
          f[10] * load_.stiffness,
          load_.equilibrium_position,
          a.stroke,
          a.return_pressure_Pa,
          a.laminar_pressure_Pa,
          a.valve_current_max_A};
}

template <class T>
plant::TermSet<T> JointModel::terms(const JointData& data, const EffectNumbers<T>& effects, Channel channel) const {
  plant::TermSet<T> set;
  for (const Model::Effect& effect : known_) {
    const std::vector<T> fitted(effect.fitted.begin(), effect.fitted.end());
    set.add(effect.id, fitted.data(), scales_, step_of(plant::effect_info(effect.id).side, data, channel));
  }
  for (const auto& [id, fitted] : effects) {
    set.add(id, fitted.data(), scales_, step_of(plant::effect_info(id).side, data, channel));
  }
  return set;
}

template <class T>
std::vector<T> JointModel::run(const JointData& data, Span span, const std::array<T, kNominals>& factors,
                               const EffectNumbers<T>& effects, Channel channel, const Observer& observer) const {
  plant::TermSet<T> terms = this->terms(data, effects, channel);
  const Constants<T> c = constants(factors);
  switch (channel) {
    case Channel::kForce:
      return run_drive<T>(data, span, OilSimulation<T>(data, c, terms, span.begin), observer.oil_s);
    case Channel::kMotion:
      return run_load<T>(data, span, LoadSimulation<T>(data, c, terms, span.begin), observer.load_s);
    case Channel::kVelocitySensor:
      break;
  }
  return run_velocity_sensor<T>(data, span, terms);
}

std::vector<double> JointModel::simulate(const JointData& data, Span span, const Model& model, Channel channel,
                                         const Observer& observer) const {
  return run<double>(data, span, model.factors, effect_numbers(model), channel, observer);
}

std::vector<double> JointModel::errors_ahead(const JointData& data, Span span, const Model& model, Channel channel,
                                             const Observer& observer, std::size_t steps, std::size_t every) const {
  const auto set = terms<double>(data, effect_numbers(model), channel);
  const Constants<double> c = constants(model.factors);
  return channel == Channel::kForce ? drive_errors_ahead(data, span, OilSimulation<double>(data, c, set, span.begin),
                                                         observer.oil_s, steps, every)
                                    : load_errors_ahead(data, span, LoadSimulation<double>(data, c, set, span.begin),
                                                        observer.load_s, steps, every);
}

std::vector<double> JointModel::simulate_lanes(const JointData& data, Span span, const Model& model, Channel channel,
                                               const Observer& observer, const std::vector<std::size_t>& lanes,
                                               std::vector<double>& jacobian) const {
  const auto jets = run<Jet>(data, span, factor_jets(model, lanes), effect_jets(model, lanes), channel, observer);
  return values_and_jacobian(jets, lanes.size(), jacobian);
}

}  // namespace farrier::diagnosis
