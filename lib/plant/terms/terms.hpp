#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "plant/terms/air_entrainment.hpp"
#include "plant/terms/backlash.hpp"
#include "plant/terms/electric_effects.hpp"
#include "plant/terms/end_stop.hpp"
#include "plant/terms/external_force.hpp"
#include "plant/terms/flexible_load.hpp"
#include "plant/terms/flow_saturation.hpp"
#include "plant/terms/force_sensor_gain.hpp"
#include "plant/terms/force_sensor_lag.hpp"
#include "plant/terms/force_sensor_offset.hpp"
#include "plant/terms/input_delay.hpp"
#include "plant/terms/internal_leakage.hpp"
#include "plant/terms/load_damping.hpp"
#include "plant/terms/load_friction.hpp"
#include "plant/terms/load_mass.hpp"
#include "plant/terms/load_stiffness.hpp"
#include "plant/terms/piston_friction.hpp"
#include "plant/terms/position_dependent_friction.hpp"
#include "plant/terms/spring_hardening.hpp"
#include "plant/terms/supply_droop.hpp"
#include "plant/terms/valve_asymmetry.hpp"
#include "plant/terms/valve_bias.hpp"
#include "plant/terms/valve_deadband.hpp"
#include "plant/terms/valve_dynamics.hpp"
#include "plant/terms/valve_hysteresis.hpp"
#include "plant/terms/velocity_filter_lag.hpp"

namespace farrier::plant {

template <class T, template <class> class... Term>
struct TermList {
  using Optionals = std::tuple<std::optional<Term<T>>...>;
  static constexpr std::size_t kCount = sizeof...(Term);
  static constexpr std::array kInfos{&Term<double>::kInfo...};
};

/// Every effect, in the order in which those of one hook act. A new one is its file and a line here, and
/// robot files, the simulated plant and sensors have it. One of the plant with a state says so (EffectInfo::has_state):
/// a class in plant/effects integrates it, or HydraulicJoint steps it.
template <class T>
using AllTerms =
    TermList<T, InputDelay, ValveHysteresis, ValveBias, ValveDynamics, ValveDeadband, ValveAsymmetry, FlowSaturation,
             SupplyDroop, InternalLeakage, AirEntrainment, Backlash, PistonFriction, EndStop, LoadMass, LoadStiffness,
             LoadDamping, SpringHardening, ExternalForce, LoadFriction, PositionDependentFriction, FlexibleLoad,
             ForceSensorLag, ForceSensorGain, ForceSensorOffset, VelocityFilterLag>;

inline constexpr std::size_t kEffectCount = AllTerms<double>::kCount;
/// Effects that a diagnosis may name: those of AllTerms, which robot files have, then kElectricEffects.
inline constexpr std::size_t kNameableCount = kEffectCount + kElectricEffects.size();
/// Place of an effect among those that a diagnosis may name: what it is called inside the program.
using EffectId = std::size_t;

constexpr const EffectInfo& effect_info(EffectId id) {
  return id < kEffectCount ? *AllTerms<double>::kInfos[id] : kElectricEffects[id - kEffectCount];
}

/// The effect of that name among those that a diagnosis may name, or kNameableCount.
constexpr EffectId find_nameable(std::string_view name) {
  EffectId id = 0;
  while (id < kNameableCount && name != effect_info(id).name) {
    ++id;
  }
  return id;
}

/// The effect of that name in AllTerms, or kEffectCount.
constexpr EffectId find_effect(std::string_view name) {
  const EffectId id = find_nameable(name);
  return id < kEffectCount ? id : kEffectCount;
}

/// The effect that is a special case of this one (EffectInfo::special_case), or kNameableCount.
constexpr EffectId special_case_of(EffectId id) {
  const char* const name = effect_info(id).special_case;
  return name != nullptr ? find_nameable(name) : kNameableCount;
}
constexpr bool is_general_form(EffectId id) { return effect_info(id).special_case != nullptr; }
/// The effect of which this one is a special case, or kNameableCount.
constexpr EffectId general_form_of(EffectId id) {
  EffectId general = 0;
  while (general < kNameableCount && special_case_of(general) != id) {
    ++general;
  }
  return general;
}

/// The terms that a joint has, with their states.
template <class T>
class TermSet {
 public:
  /// `fitted` are the numbers of the effect's parameters; `step_s` how far a call of its hooks reaches.
  void add(EffectId id, const T* fitted, const Scales& scales, double step_s) noexcept {
    for_each_place([&]<std::size_t I>() {
      if (I == id) {
        std::get<I>(terms_).emplace(fitted, scales, step_s);
      }
    });
  }

  void on_valve(ValveMoment<T>& now) noexcept {
    each([&](auto& term) {
      if constexpr (requires { term.on_valve(now); }) {
        term.on_valve(now);
      }
    });
  }
  void on_oil(OilMoment<T>& now) noexcept {
    each([&](auto& term) {
      if constexpr (requires { term.on_oil(now); }) {
        term.on_oil(now);
      }
    });
  }
  void on_play(PlayMoment<T>& now) noexcept {
    each([&](auto& term) {
      if constexpr (requires { term.on_play(now); }) {
        term.on_play(now);
      }
    });
  }
  void on_piston(PistonMoment<T>& now) noexcept {
    each([&](auto& term) {
      if constexpr (requires { term.on_piston(now); }) {
        term.on_piston(now);
      }
    });
  }
  void on_load(LoadMoment<T>& now) noexcept {
    each([&](auto& term) {
      if constexpr (requires { term.on_load(now); }) {
        term.on_load(now);
      }
    });
  }
  void after_load(const T& mean_velocity) noexcept {
    each([&](auto& term) {
      if constexpr (requires { term.after_load(mean_velocity); }) {
        term.after_load(mean_velocity);
      }
    });
  }
  /// A substep in which the load is moved at that mean velocity, by whatever forces.
  void follow_load(const T& mean_velocity) noexcept {
    each([&](auto& term) {
      if constexpr (requires { term.follow_load(mean_velocity); }) {
        term.follow_load(mean_velocity);
      }
    });
  }
  void on_force(ForceMoment<T>& now) noexcept {
    each([&](auto& term) {
      if constexpr (requires { term.on_force(now); }) {
        term.on_force(now);
      }
    });
  }
  T on_velocity(T velocity) noexcept {
    each([&](auto& term) {
      if constexpr (requires { term.on_velocity(velocity); }) {
        velocity = term.on_velocity(velocity);
      }
    });
    return velocity;
  }
  /// Numbers of the joint's terms that have a hook of the plant.
  struct Hooks {
    int valve = 0, oil = 0, piston = 0, load = 0;
  };
  Hooks hooks() const noexcept {
    Hooks any;
    std::apply([&](const auto&... term) { ((term ? note(*term, any) : void()), ...); }, terms_);
    return any;
  }
  /// The term of that kind, null for none.
  template <template <class> class Term>
  const Term<T>* find() const noexcept {
    const auto& term = std::get<std::optional<Term<T>>>(terms_);
    return term ? &*term : nullptr;
  }

 private:
  template <class Term>
  static void note(const Term&, Hooks& any) noexcept {
    any.valve += requires(Term & term, ValveMoment<T> & now) { term.on_valve(now); };
    any.oil += requires(Term & term, OilMoment<T> & now) { term.on_oil(now); };
    any.piston += requires(Term & term, PistonMoment<T> & now) { term.on_piston(now); };
    any.load += requires(Term & term, LoadMoment<T> & now) { term.on_load(now); };
  }
  template <class F>
  static void for_each_place(F&& f) noexcept {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (f.template operator()<I>(), ...); }
    (std::make_index_sequence<kEffectCount>());
  }
  template <class F>
  void each(F&& f) noexcept {
    std::apply([&](auto&... term) { ((term ? f(*term) : void()), ...); }, terms_);
  }

  typename AllTerms<T>::Optionals terms_;
};

}  // namespace farrier::plant
