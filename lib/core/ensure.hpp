#pragma once

namespace farrier {

/// Reports a broken invariant (a bug, never a plant or link fault) and aborts.
[[noreturn]] void ensure_failed(const char* condition, const char* what, const char* file, int line) noexcept;

}  // namespace farrier

/// Checks an invariant at set-up time. Never used inside the control loop.
#define FARRIER_ENSURE(condition, what) \
  ((condition) ? static_cast<void>(0) : ::farrier::ensure_failed(#condition, what, __FILE__, __LINE__))
