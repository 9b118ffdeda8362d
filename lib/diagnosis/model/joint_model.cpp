#include "diagnosis/model/joint_model.hpp"

#include <algorithm>

#include "diagnosis/model/jets.hpp"

namespace farrier::diagnosis {

namespace {

/// Terms of sensors act once per sample, the others once per substep.
double step_of(plant::Side side, const JointData& data) noexcept {
  switch (side) {
    case plant::Side::kValveAndOil:
      return data.step_s();
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
plant::TermSet<T> JointModel::terms(const JointData& data, const EffectNumbers<T>& effects) const {
  plant::TermSet<T> set;
  for (const Model::Effect& effect : known_) {
    const std::vector<T> fitted(effect.fitted.begin(), effect.fitted.end());
    set.add(effect.id, fitted.data(), scales_, step_of(plant::effect_info(effect.id).side, data));
  }
  for (const auto& [id, fitted] : effects) {
    set.add(id, fitted.data(), scales_, step_of(plant::effect_info(id).side, data));
  }
  return set;
}

template <class T>
std::vector<T> JointModel::run(const JointData& data, Span span, const std::array<T, kNominals>& factors,
                               const EffectNumbers<T>& effects, Channel channel, const Observer& observer) const {
  plant::TermSet<T> terms = this->terms(data, effects);
  const Constants<T> c = constants(factors);
  std::vector<T> out;
  out.reserve(span.size());
  switch (channel) {
    case Channel::kForce:
      simulate_oil(data, span, c, terms, observer.oil_s, [&](std::size_t, const T& force) { out.push_back(force); });
      break;
    case Channel::kMotion: {
      // The smoother turns the error in position into an error in velocity plus a weighted error in position, where a
      // constant force shows. It is linear.
      simulate_load(data, span, c, terms, observer.load_s,
                    [&](std::size_t k, const T& position) { out.push_back(data.measured_position[k] - position); });
      for (std::size_t from = 0; from < out.size();) {
        std::size_t to = from + 1;
        while (to < out.size() && knows_load(data, span.begin + to) == knows_load(data, span.begin + from)) {
          ++to;
        }
        const std::vector<T> stretch(out.begin() + std::ptrdiff_t(from), out.begin() + std::ptrdiff_t(to));
        const auto error = data.smoother.smooth<T>(stretch, {stretch[0], T(0.0), T(0.0)});
        for (std::size_t i = from; i < to; ++i) {
          const std::array<T, 3>& e = error[i - from];
          out[i] = data.motion[span.begin + i] - (e[1] + e[0] / JointData::kMotionTime_s);
        }
        from = to;
      }
      break;
    }
    case Channel::kVelocitySensor:
      for (std::size_t k = span.begin; k < span.end; ++k) {
        out.push_back(terms.on_velocity(T(data.velocity[k])));
      }
      break;
  }
  return out;
}

namespace {

EffectNumbers<double> numbers(const Model& model) {
  EffectNumbers<double> effects;
  for (const Model::Effect& effect : model.effects) {
    effects.emplace_back(effect.id, effect.fitted);
  }
  return effects;
}

}  // namespace

std::vector<double> JointModel::simulate(const JointData& data, Span span, const Model& model, Channel channel,
                                         const Observer& observer) const {
  return run<double>(data, span, model.factors, numbers(model), channel, observer);
}

std::vector<double> JointModel::errors_ahead(const JointData& data, Span span, const Model& model, Channel channel,
                                             const Observer& observer, std::size_t steps, std::size_t every) const {
  const auto set = terms<double>(data, numbers(model));
  const Constants<double> c = constants(model.factors);
  OilSimulation<double> oil(data, c, set, span.begin);
  LoadSimulation<double> load(data, c, set, span.begin);
  std::vector<double> errors;
  for (std::size_t k = span.begin; k + steps < span.end; ++k) {
    const bool leaves = (k - span.begin) % every == 0;
    if (channel == Channel::kForce) {
      if (leaves) {
        auto ahead = oil;
        for (std::size_t i = k; i < k + steps; ++i) {
          ahead.read(i);
          ahead.advance(i, 0.0, 0.0);
        }
        errors.push_back(data.force[k + steps] - ahead.read(k + steps));
      }
      const double force = oil.read(k);
      oil.advance(k, data.force[k] - force, pull_of(data.period_s, observer.oil_s));
    } else {
      if (leaves) {
        auto ahead = load;
        ahead.settle(k);
        for (std::size_t i = k; i < k + steps; ++i) {
          ahead.advance(i, 0.0);
        }
        const double error = data.position[k + steps] - ahead.read();
        errors.push_back(knows_load(data, k) && knows_load(data, k + steps) ? error / JointData::kMotionTime_s : 0.0);
      }
      load.advance(k, pull_of(data.period_s, observer.load_s));
    }
  }
  return errors;
}

std::vector<double> JointModel::simulate_lanes(const JointData& data, Span span, const Model& model, Channel channel,
                                               const Observer& observer, const std::vector<std::size_t>& lanes,
                                               std::vector<double>& jacobian) const {
  std::array<Jet, kNominals> factors;
  for (std::size_t i = 0; i < kNominals; ++i) {
    factors[i] = jet_at(i, model.factors[i], lanes);
  }
  const auto jets = run<Jet>(data, span, factors, effect_jets(model, lanes), channel, observer);
  return values_and_jacobian(jets, lanes.size(), jacobian);
}

}  // namespace farrier::diagnosis
