#include "diagnosis/model/electric_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "diagnosis/model/electric_load.hpp"
#include "diagnosis/model/electric_response.hpp"
#include "diagnosis/model/electric_starts.hpp"
#include "diagnosis/model/jets.hpp"
#include "diagnosis/model/side_runs.hpp"

namespace farrier::diagnosis {
namespace {

constexpr ChannelMask kOnDrive{true, false, false};
constexpr ChannelMask kOnLoad{false, true, false};

/// Effects of hydraulic joints that electric ones have too.
constexpr std::array kShared{"input_delay",      "backlash",          "load_mass",           "load_stiffness",
                             "load_damping",     "spring_hardening",  "external_force",      "load_friction",
                             "force_sensor_lag", "force_sensor_gain", "force_sensor_offset", "velocity_filter_lag"};

constexpr double kHold_Hz = 2.0;

constexpr std::size_t kLoadNominals = static_cast<std::size_t>(Nominal::kMass);

bool is(plant::EffectId id, std::string_view name) noexcept { return plant::effect_info(id).name == name; }

}  // namespace

ElectricModel::ElectricModel(const plant::ElectricParams& drive, const plant::LoadParams& load, double rated_torque_Nm)
    : drive_(drive), load_(load), scales_(drive, load, rated_torque_Nm) {}

ChannelMask ElectricModel::channels(plant::EffectId id) const noexcept {
  const plant::EffectInfo& info = plant::effect_info(id);
  const bool shared = std::ranges::any_of(kShared, [&](std::string_view name) { return name == info.name; });
  if (id < plant::kEffectCount && !shared) {
    return {};
  }
  if (info.side == plant::Side::kForceSensor) {
    return drive_.rigid ? ChannelMask{} : channels_of(info.side);
  }
  if (is(id, "rotor_inertia") || is(id, "gear_friction")) {
    return drive_.rigid ? ChannelMask{} : kOnDrive;
  }
  if (is(id, "torque_constant") || is(id, "gear_stiffness") || is(id, "cogging") || is(id, "backlash")) {
    return drive_.rigid ? kOnLoad : kOnDrive;
  }
  return channels_of(info.side);
}

ChannelMask ElectricModel::nominal_channels(std::size_t factor) const noexcept {
  if (factor >= kLoadNominals) {
    const bool absent = (factor == static_cast<std::size_t>(Nominal::kStiffness) && load_.stiffness == 0.0) ||
                        (factor == static_cast<std::size_t>(Nominal::kDamping) && load_.damping == 0.0);
    return absent ? ChannelMask{} : kOnLoad;
  }
  const auto mine = [&](bool there, bool rigid_too) {
    return !there || (drive_.rigid && !rigid_too) ? ChannelMask{} : drive_.rigid ? kOnLoad : kOnDrive;
  };
  switch (static_cast<DriveNominal>(factor)) {
    case DriveNominal::kTorqueConstant:
      return mine(true, true);
    case DriveNominal::kRotor:
      return mine(drive_.rotor_inertia_kg_m2 > 0.0, true);
    case DriveNominal::kDamping:
      return mine(drive_.damping > 0.0, true);
    case DriveNominal::kCoulomb:
      return mine(drive_.coulomb > 0.0, true);
    case DriveNominal::kResistance:
    case DriveNominal::kInductance:
    case DriveNominal::kStiffness:
      return mine(true, false);
    case DriveNominal::kLag:
      return drive_.rigid ? kOnDrive : ChannelMask{};
  }
  return {};
}

std::size_t ElectricModel::replaced(plant::EffectId id) const noexcept {
  if (is(id, "rotor_inertia")) {
    return static_cast<std::size_t>(DriveNominal::kRotor);
  }
  if (is(id, "torque_constant")) {
    return static_cast<std::size_t>(DriveNominal::kTorqueConstant);
  }
  if (is(id, "gear_stiffness")) {
    return static_cast<std::size_t>(DriveNominal::kStiffness);
  }
  return replaced_of_load(id);
}

bool ElectricModel::fits(plant::EffectId id, std::size_t parameter) const noexcept {
  const bool relaxation = is(id, "gear_stiffness") && parameter == 1;
  const bool flanks = is(id, "backlash") && parameter == 1;
  return !plant::effect_info(id).parameters[parameter].held && !(relaxation && !drive_.rigid) && !flanks;
}

std::vector<std::vector<double>> ElectricModel::starts(plant::EffectId id, const JointData& data) const {
  const ChannelMask shows = channels(id);
  if (!meet(shows, shows)) {
    return {};
  }
  if (is(id, "current_limit")) {
    return starts_of_limit(data, scales_);
  }
  if (is(id, "cogging")) {
    return starts_of_cogging(data, drive_, load_, scales_);
  }
  if (is(id, "gravity")) {
    return starts_of_gravity(data, drive_, load_, scales_);
  }
  if (is(id, "gear_stiffness")) {
    const auto& [stiffness, relaxation] = plant::kGearStiffnessParameters;
    return drive_.rigid ? std::vector<std::vector<double>>{{0.3, relaxation.starts[0]}, {3.0, relaxation.starts[0]}}
                        : std::vector<std::vector<double>>{
                              {stiffness.starts[0], drive_.spring_damping / drive_.spring_stiffness}};
  }
  return usual_starts(*this, id, data);
}

JointData ElectricModel::prepared(const Recording& recording, double position_noise) const {
  return prepare(recording, position_noise);
}

/// A joint with a model's factors and effects.
template <class T>
struct ElectricModel::Parts {
  DriveNumbers<T> drive;
  LoadNumbers<T> load;
  plant::TermSet<T> terms;  ///< effects of input, load and sensors
};

template <class T>
ElectricModel::Parts<T> ElectricModel::parts(const Steps& steps, const std::array<T, kNominals>& factors,
                                             const EffectNumbers<T>& effects) const {
  const auto of_load = [&](Nominal place) { return factors[static_cast<std::size_t>(place)]; };
  Parts<T> parts{drive_numbers(drive_, scales_, factors, effects, steps.drive_s),
                 {of_load(Nominal::kMass) * load_.mass, of_load(Nominal::kDamping) * load_.damping,
                  of_load(Nominal::kStiffness) * load_.stiffness, load_.equilibrium_position},
                 {}};
  for (const auto& [id, fitted] : effects) {
    if (id < plant::kEffectCount && !is(id, "backlash")) {
      const bool of_side = plant::effect_info(id).side == plant::Side::kLoad;
      parts.terms.add(id, fitted.data(), scales_, of_side ? steps.load_s : steps.period_s);
    }
  }
  return parts;
}

ElectricModel::Steps ElectricModel::steps_of(const JointData& data) noexcept {
  return {data.period_s, DriveSimulation<double>::step_of(data), data.load_step_s()};
}

template <class T>
std::vector<T> ElectricModel::run(const JointData& data, Span span, const std::array<T, kNominals>& factors,
                                  const EffectNumbers<T>& effects, Channel channel, const Observer& observer) const {
  Parts<T> joint = parts(steps_of(data), factors, effects);
  switch (channel) {
    case Channel::kForce:
      return run_drive<T>(data, span, DriveSimulation<T>(data, joint.drive, joint.terms, span.begin), observer.oil_s);
    case Channel::kMotion:
      return run_load<T>(
          data, span, ElectricLoad<T>(data, joint.drive, joint.load, joint.terms, joint.drive, joint.terms, span.begin),
          observer.load_s);
    case Channel::kVelocitySensor:
      break;
  }
  return run_velocity_sensor<T>(data, span, joint.terms);
}

std::vector<double> ElectricModel::simulate(const JointData& data, Span span, const Model& model, Channel channel,
                                            const Observer& observer) const {
  return run<double>(data, span, model.factors, effect_numbers(model), channel, observer);
}

std::vector<double> ElectricModel::simulate_lanes(const JointData& data, Span span, const Model& model, Channel channel,
                                                  const Observer& observer, const std::vector<std::size_t>& lanes,
                                                  std::vector<double>& jacobian) const {
  const std::array<Jet, kNominals> factors = factor_jets(model, lanes);
  const EffectNumbers<Jet> effects = effect_jets(model, lanes);
  if (channel != Channel::kMotion || moves_drive(model, lanes)) {
    return values_and_jacobian(run<Jet>(data, span, factors, effects, channel, observer), lanes.size(), jacobian);
  }
  const Parts<double> drive = parts<double>(steps_of(data), model.factors, effect_numbers(model));
  const Parts<Jet> joint = parts(steps_of(data), factors, effects);
  const ElectricLoad<Jet, double> load(data, joint.drive, joint.load, joint.terms, drive.drive, drive.terms,
                                       span.begin);
  return values_and_jacobian(run_load<Jet>(data, span, load, observer.load_s), lanes.size(), jacobian);
}

bool ElectricModel::moves_drive(const Model& model, const std::vector<std::size_t>& lanes) const noexcept {
  const auto has = [&](std::size_t place) { return std::ranges::find(lanes, place) != lanes.end(); };
  for (std::size_t i = 0; i < kNominals; ++i) {
    if (has(i) && nominal_channels(i)[0]) {
      return true;
    }
  }
  std::size_t place = kNominals;
  for (const Model::Effect& effect : model.effects) {
    for (std::size_t i = 0; i < effect.fitted.size(); ++i, ++place) {
      if (has(place) && channels(effect.id)[0]) {
        return true;
      }
    }
  }
  return false;
}

std::vector<double> ElectricModel::errors_ahead(const JointData& data, Span span, const Model& model, Channel channel,
                                                const Observer& observer, std::size_t steps, std::size_t every) const {
  const Parts<double> joint = parts<double>(steps_of(data), model.factors, effect_numbers(model));
  return channel == Channel::kForce
             ? drive_errors_ahead(data, span, DriveSimulation<double>(data, joint.drive, joint.terms, span.begin),
                                  observer.oil_s, steps, every)
             : load_errors_ahead(data, span,
                                 ElectricLoad<double>(data, joint.drive, joint.load, joint.terms, joint.drive,
                                                      joint.terms, span.begin),
                                 observer.load_s, steps, every);
}

Hold ElectricModel::hold() const noexcept {
  const double mass = load_.mass + (drive_.rigid ? plant::armature_kg_m2(drive_) : 0.0);
  const double rate = 2.0 * std::numbers::pi * kHold_Hz;
  const double stiffness = std::min(mass * rate * rate, largest_force() / drive_.travel);
  return {stiffness, std::sqrt(stiffness * mass)};
}

std::vector<plant::JointReadings> ElectricModel::respond(const Model& model, std::span<const double> current_A,
                                                         double period_s) const {
  const double step_s = period_s / kWholeSubsteps;
  const Parts<double> whole = parts<double>({period_s, step_s, step_s}, model.factors, effect_numbers(model));
  return electric_response({whole.drive, whole.load, whole.terms, 0.5 * drive_.travel, hold()}, current_A, period_s);
}

}  // namespace farrier::diagnosis
