#pragma once

namespace farrier::test {

/// Factor of every bound on time: programs under sanitizers are several times slower.
#if defined(__has_feature)  // clang
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define FARRIER_IS_SLOW 1
#endif
#endif
#if defined(FARRIER_IS_SLOW) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int kSlowness = 20;
#else
inline constexpr int kSlowness = 1;
#endif

}  // namespace farrier::test
