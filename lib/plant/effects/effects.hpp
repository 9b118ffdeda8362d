#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include "plant/actuator.hpp"
#include "plant/effects/effect.hpp"
#include "plant/effects/stateless_terms.hpp"
#include "plant/effects/supply_line.hpp"

namespace farrier::plant {

template <class... Terms>
struct EffectList {
  using Tuple = std::tuple<Terms...>;
  static constexpr std::size_t kStates = (Terms::kStates + ...);

  /// Place where the states of one of them begin.
  template <class Term>
  static constexpr std::size_t offset() {
    std::size_t before = 0;
    bool found = false;
    ((found = found || std::is_same_v<Term, Terms>, before += found ? 0 : Terms::kStates), ...);
    return before;
  }
};

/// Puts those `effects` into the parameters of a joint that the parameters can represent: valve_dynamics replaces the
/// spool, load_friction the friction of the load.
ActuatorParams with_effects(const ActuatorParams& actuator, std::span<const ActiveEffect> effects) noexcept;
LoadParams with_effects(const LoadParams& load, const ActuatorParams& actuator,
                        std::span<const ActiveEffect> effects) noexcept;

/// Least way, m or rad, over which a contact of that breakaway ratio may bend: less slides too fast for the shortest
/// substep at the joint's full speed.
double least_presliding(const ActuatorParams& actuator, double breakaway_ratio) noexcept;

/// Refuses numbers that are not finite, that lie on the wrong side of 0, and an effect that is there twice.
Result<Done> validate(std::span<const ActiveEffect> effects);

/// Every effect of a joint, in the order in which they act: on the way from the command to the valve's opening, then
/// from the valve to the chambers, then on the load. Their states are stored one after the other.
class Effects {
 public:
  using List = EffectList<Spool, SupplyLine, Lines, Friction, SealFriction, StatelessTerms>;
  using X = std::array<double, List::kStates>;

  template <class Term>
  static constexpr std::size_t at() {
    return List::offset<Term>();
  }

  /// Takes the effects in the parameters and, of `effects`, those that are not in them.
  Effects(const ActuatorParams& actuator, const LoadParams& load, std::span<const ActiveEffect> effects) noexcept;

  /// Sets another load from now on; returns the states that follow.
  X set_load(const LoadParams& load, const X& x) noexcept;

  bool active() const noexcept;
  double fastest_rate(double mass) const noexcept;
  X scale() const noexcept;
  X rest(const RestPoint& at) const noexcept;

  void before_valve(Instant& now, const X& x) const noexcept {
    for_each([&]<std::size_t At>(const auto& term) noexcept {
      if (term.active()) {
        term.before_valve(now, part<At>(term, x));
      }
    });
  }
  /// Rates of all states; of inactive effects 0.
  X after_valve(Instant& now, const X& x) const noexcept {
    X dx{};
    for_each([&]<std::size_t At>(const auto& term) noexcept {
      if (term.active()) {
        auto rates = part<At>(term, dx);
        term.after_valve(now, part<At>(term, x), rates);
        place<At>(rates, dx);
      }
    });
    return dx;
  }

  const Lines& lines() const noexcept { return std::get<Lines>(terms_); }

 private:
  template <std::size_t At, class Term>
  static auto part(const Term&, const X& x) noexcept {
    typename Term::X mine{};
    for (std::size_t i = 0; i < mine.size(); ++i) {
      mine[i] = x[At + i];
    }
    return mine;
  }
  template <std::size_t At, std::size_t N>
  static void place(const std::array<double, N>& mine, X& x) noexcept {
    for (std::size_t i = 0; i < N; ++i) {
      x[At + i] = mine[i];
    }
  }
  template <class F>
  void for_each(F&& f) const noexcept {
    std::apply(
        [&](const auto&... term) noexcept {
          (f.template operator()<at<std::remove_cvref_t<decltype(term)>>()>(term), ...);
        },
        terms_);
  }

  List::Tuple terms_;
};

}  // namespace farrier::plant
