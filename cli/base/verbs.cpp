#include "cli/base/verbs.hpp"

#include <algorithm>

namespace farrier::cli {
namespace {

constexpr Verb kVerbs[] = {
#define FARRIER_VERB(name, program, sentence) {#name, #program, sentence},
#include "cli/verbs.def"
#undef FARRIER_VERB
};

}  // namespace

std::span<const Verb> verbs() noexcept { return kVerbs; }

const Verb* find_verb(std::string_view name) noexcept {
  const auto found = std::ranges::find(kVerbs, name, &Verb::name);
  return found == std::end(kVerbs) ? nullptr : found;
}

}  // namespace farrier::cli
