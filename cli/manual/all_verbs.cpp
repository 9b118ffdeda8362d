#include "cli/manual/all_verbs.hpp"

#include <CLI/CLI.hpp>

#include "cli/base/command.hpp"

namespace farrier::cli {
namespace {

constexpr DeclaredVerb kAllVerbs[] = {
#define FARRIER_VERB(name, program, sentence) {#name, declare_##name},
#include "cli/verbs.def"
#undef FARRIER_VERB
};

}  // namespace

std::span<const DeclaredVerb> all_verbs() noexcept { return kAllVerbs; }

std::unique_ptr<CLI::App> whole_command_line() {
  std::function<int()> unused;  // nothing is parsed
  return command_line(kAllVerbs, unused);
}

}  // namespace farrier::cli
