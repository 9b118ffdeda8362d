#include "core/ensure.hpp"

#include <cstdio>
#include <cstdlib>

namespace farrier {

void ensure_failed(const char* condition, const char* what, const char* file, int line) noexcept {
  std::fprintf(stderr, "farrier: bug: %s (%s) at %s:%d\n", what, condition, file, line);
  std::abort();
}

}  // namespace farrier
