#pragma once

namespace farrier::test {

/// What a bound on time is multiplied by: programs under sanitizers are several times slower.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int kSlowness = 20;
#else
inline constexpr int kSlowness = 1;
#endif

}  // namespace farrier::test
