#include "body/engine/engine_fault.hpp"

namespace farrier::body {

const char* to_string(EngineFault fault) noexcept {
  switch (fault) {
    case EngineFault::kSingularInertia:
      return "the inertia is singular";
    case EngineFault::kTooManyContacts:
      return "too many contacts";
    case EngineFault::kTooManyConstraints:
      return "too many constraints";
    case EngineFault::kPositionNotFinite:
      return "a position is not finite or huge";
    case EngineFault::kVelocityNotFinite:
      return "a velocity is not finite or huge";
    case EngineFault::kAccelerationNotFinite:
      return "an acceleration is not finite or huge";
    case EngineFault::kOther:
      return "another warning of the engine";
  }
  return "unknown";
}

}  // namespace farrier::body
