#pragma once

#include <string>
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

  T& value() & {
    FARRIER_ENSURE(ok(), "value() of a refused Result");
    return std::get<0>(state_);
  }
  const T& value() const& {
    FARRIER_ENSURE(ok(), "value() of a refused Result");
    return std::get<0>(state_);
  }
  T&& value() && {
    FARRIER_ENSURE(ok(), "value() of a refused Result");
    return std::get<0>(std::move(state_));
  }
  const E& error() const {
    FARRIER_ENSURE(!ok(), "error() of a successful Result");
    return std::get<1>(state_);
  }

 private:
  std::variant<T, E> state_;
};

/// The value of a Result; if it was refused, the function around it returns the error:
///   const robot::Robot robot = FARRIER_TRY(robot::load_robot(path));
/// A statement expression, which GCC and Clang have in common.
#define FARRIER_TRY(...)              \
  ({                                  \
    auto tried_result = __VA_ARGS__;  \
    if (!tried_result) {              \
      return tried_result.error();    \
    }                                 \
    std::move(tried_result).value();  \
  })

}  // namespace farrier
