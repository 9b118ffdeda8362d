#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/ensure.hpp"

namespace farrier {

/// Why an operation was refused: one sentence that names the place and the remedy.
struct Error {
  std::string message;
};

/// Success without a value, for operations that are either done or refused.
struct Done {};

/// The value of an operation that may be refused at set-up or solve time, or the reason it was.
/// Failures a caller must tell apart use their own enum as E; everything else uses Error.
template <class T, class E = Error>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(E error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const noexcept { return state_.index() == 0; }
  explicit operator bool() const noexcept { return ok(); }

  /// The value. Calling it on a refusal is a bug: it prints the error and aborts.
  T& value() & {
    FARRIER_ENSURE(ok(), text_of_refusal().c_str());
    return std::get<0>(state_);
  }
  const T& value() const& {
    FARRIER_ENSURE(ok(), text_of_refusal().c_str());
    return std::get<0>(state_);
  }
  T&& value() && {
    FARRIER_ENSURE(ok(), text_of_refusal().c_str());
    return std::get<0>(std::move(state_));
  }
  const E& error() const {
    FARRIER_ENSURE(!ok(), "error() of a successful Result");
    return std::get<1>(state_);
  }

  /// Returns the result of `next`, a function of the value, or this refusal:
  ///   load_robot(path).and_then([](robot::Robot robot) { return make_estimators(robot); })
  template <class Next>
  auto and_then(Next&& next) && -> std::invoke_result_t<Next, T&&> {
    if (!ok()) {
      return error();
    }
    return std::forward<Next>(next)(std::get<0>(std::move(state_)));
  }
  template <class Next>
  auto and_then(Next&& next) const& -> std::invoke_result_t<Next, const T&> {
    if (!ok()) {
      return error();
    }
    return std::forward<Next>(next)(std::get<0>(state_));
  }

 private:
  [[gnu::cold, gnu::noinline]] std::string text_of_refusal() const {
    std::string text = "value() of a refused Result";
    if constexpr (std::is_same_v<E, Error>) {
      text += ": " + error().message;
    }
    return text;
  }

  std::variant<T, E> state_;
};

/// The value of a Result; if it was refused, the function around it returns the error:
///   const robot::Robot robot = FARRIER_TRY(robot::load_robot(path));
/// A statement expression, which GCC and Clang have in common.
#define FARRIER_TRY(...)             \
  ({                                 \
    auto tried_result = __VA_ARGS__; \
    if (!tried_result) {             \
      return tried_result.error();   \
    }                                \
    std::move(tried_result).value(); \
  })

}  // namespace farrier
