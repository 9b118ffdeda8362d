#pragma once

#include <cstdint>

namespace farrier::body {

/// The engine's reason to stop. Each of them is a failure of the run: MuJoCo would reset the state and go on.
enum class EngineFault {
  kSingularInertia,
  kTooManyContacts,
  kTooManyConstraints,
  kPositionNotFinite,
  kVelocityNotFinite,
  kAccelerationNotFinite,
  kOther,
};
const char* to_string(EngineFault fault) noexcept;

/// A fault, with the number of the step in which it occurred.
struct EngineFailure {
  EngineFault fault;
  std::int64_t step;
};

}  // namespace farrier::body
