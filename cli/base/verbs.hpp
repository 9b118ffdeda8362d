#pragma once

#include <span>
#include <string_view>

namespace farrier::cli {

/// A line of cli/verbs.def.
struct Verb {
  std::string_view name;
  std::string_view program;   ///< that runs it; "farrier" is the command itself
  std::string_view sentence;  ///< without a full stop
};

/// Every verb, in the order in which help lists them.
std::span<const Verb> verbs() noexcept;

/// Null when there is no verb of that name.
const Verb* find_verb(std::string_view name) noexcept;

}  // namespace farrier::cli
