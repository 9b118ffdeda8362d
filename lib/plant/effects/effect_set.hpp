#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

#include "plant/effects/effect.hpp"

namespace farrier::plant {

/// Effects of a joint, in the order in which they act. Their states are stored one after the other; hooks of those that
/// are not active are not called.
template <class... Terms>
class EffectSet {
 public:
  static constexpr std::size_t kStates = (Terms::kStates + ...);
  using X = std::array<double, kStates>;

  template <class Term>
  static constexpr bool has() {
    return (std::is_same_v<Term, Terms> || ...);
  }
  /// Place where the states of one of them begin.
  template <class Term>
  static constexpr std::size_t at() {
    std::size_t before = 0;
    bool found = false;
    ((found = found || std::is_same_v<Term, Terms>, before += found ? 0 : Terms::kStates), ...);
    return before;
  }

  explicit EffectSet(const Terms&... terms) noexcept : terms_(terms...) {}

  bool active() const noexcept {
    return std::apply([](const auto&... term) noexcept { return (term.active() || ...); }, terms_);
  }
  double fastest_rate(double mass) const noexcept {
    double fastest = 0.0;
    for_each([&]<std::size_t>(const auto& term) noexcept {
      if (term.active()) {
        fastest = std::max(fastest, term.fastest_rate(mass));
      }
    });
    return fastest;
  }
  X scale() const noexcept {
    X all{};
    for_each([&]<std::size_t At>(const auto& term) noexcept { place<At>(term.scale(), all); });
    return all;
  }
  X rest(const RestPoint& point) const noexcept {
    X all{};
    for_each([&]<std::size_t At>(const auto& term) noexcept { place<At>(term.rest(point), all); });
    return all;
  }

  void before_valve(Instant& now, const X& x) const noexcept {
    for_each([&]<std::size_t At>(const auto& term) noexcept {
      if (acts(term)) {
        term.before_valve(now, part<At>(term, x));
      }
    });
  }
  /// Rates of all states; of inactive effects 0.
  X after_valve(Instant& now, const X& x) const noexcept {
    X dx{};
    for_each([&]<std::size_t At>(const auto& term) noexcept {
      if (acts(term)) {
        auto rates = part<At>(term, dx);
        term.after_valve(now, part<At>(term, x), rates);
        place<At>(rates, dx);
      }
    });
    return dx;
  }
  bool bends_at_rest() const noexcept {
    return std::apply([](const auto&... term) noexcept { return (term.bends_at_rest() || ...); }, terms_);
  }
  void settle(double velocity, X& x, X& dx) const noexcept {
    for_each([&]<std::size_t At>(const auto& term) noexcept {
      if (acts(term)) {
        auto mine = part<At>(term, x);
        auto rates = part<At>(term, dx);
        term.settle(velocity, mine, rates);
        place<At>(mine, x);
        place<At>(rates, dx);
      }
    });
  }

  template <class Term>
  const Term& get() const noexcept {
    return std::get<Term>(terms_);
  }
  /// States of these effects out of those of a set that has them too, and back.
  template <class All>
  static X out_of(const typename All::X& all) noexcept {
    X mine{};
    (copy<Terms::kStates>(all, All::template at<Terms>(), mine, at<Terms>()), ...);
    return mine;
  }
  template <class All>
  static void put_into(typename All::X& all, const X& mine) noexcept {
    (copy<Terms::kStates>(mine, at<Terms>(), all, All::template at<Terms>()), ...);
  }

  template <class Term>
  Term& change() noexcept {
    return std::get<Term>(terms_);
  }

 private:
  template <std::size_t N, class From, class To>
  static void copy(const From& from, std::size_t from_at, To& to, std::size_t to_at) noexcept {
    for (std::size_t i = 0; i < N; ++i) {
      to[to_at + i] = from[from_at + i];
    }
  }
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
  template <class Term>
  static bool acts(const Term& term) noexcept {
    return Term::kNeutralUnlessActive || term.active();
  }
  template <class F>
  void for_each(F&& f) const noexcept {
    std::apply(
        [&](const auto&... term) noexcept {
          (f.template operator()<at<std::remove_cvref_t<decltype(term)>>()>(term), ...);
        },
        terms_);
  }

  std::tuple<Terms...> terms_;
};

}  // namespace farrier::plant
