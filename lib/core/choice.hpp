#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "core/ensure.hpp"
#include "core/result.hpp"

namespace farrier {

/// One value of an enum by the name that files, command lines and reports have for it.
template <class E>
struct Option {
  const char* name;
  E value;
};

/// The name of a value, which must be among the options.
template <class Options, class E>
const char* name_of(const Options& options, E value) noexcept {
  const auto option = std::ranges::find_if(options, [&](const auto& one) { return one.value == value; });
  FARRIER_ENSURE(option != std::ranges::end(options), "every value of an enum has a name");
  return option->name;
}

/// The names in their order: "cyclone, fast".
template <class Options>
std::string names_of(const Options& options, const char* between = ", ") {
  std::string names;
  for (const auto& option : options) {
    names += (names.empty() ? "" : between) + std::string(option.name);
  }
  return names;
}

/// The value of a name. Refuses a name that no option has: "there is no design 'x': give one of stance, swing".
template <class Options>
auto parse_choice(const char* what, const Options& options, std::string_view name)
    -> Result<decltype(std::ranges::begin(options)->value)> {
  for (const auto& option : options) {
    if (option.name == name) {
      return option.value;
    }
  }
  return Error{"there is no " + std::string(what) + " '" + std::string(name) + "': give one of " + names_of(options)};
}

}  // namespace farrier
