#include "signals/signals.hpp"

#include <type_traits>

#include "signals/fields.hpp"

namespace farrier::signals {

#define FARRIER_CHECK(Signal, file) static_assert(std::is_trivially_copyable_v<Signal>);
FARRIER_SIGNALS(FARRIER_CHECK)
#undef FARRIER_CHECK

const char* to_string(Mode mode) noexcept {
  switch (mode) {
    case Mode::kIdle: return "idle";
    case Mode::kArmed: return "armed";
    case Mode::kStopped: return "stopped";
  }
  return "unknown mode";
}

const char* to_string(Request request) noexcept {
  switch (request) {
    case Request::kArm: return "arm";
    case Request::kStop: return "stop";
  }
  return "unknown request";
}

const char* to_string(JointState state) noexcept {
  switch (state) {
    case JointState::kNull: return "null";
    case JointState::kDamping: return "damping";
    case JointState::kTracking: return "tracking";
  }
  return "unknown state";
}

const char* to_string(Severity severity) noexcept {
  switch (severity) {
    case Severity::kInfo: return "info";
    case Severity::kWarning: return "warning";
    case Severity::kError: return "error";
  }
  return "unknown severity";
}

const char* to_string(UpdateVerdict verdict) noexcept {
  switch (verdict) {
    case UpdateVerdict::kAccepted: return "accepted";
    case UpdateVerdict::kNotDifferentEnough: return "not different enough";
    case UpdateVerdict::kNotConverged: return "not converged";
    case UpdateVerdict::kNotValid: return "not valid";
    case UpdateVerdict::kDesignRefused: return "design refused";
    case UpdateVerdict::kUnstableOnEstimate: return "unstable on the estimate";
    case UpdateVerdict::kUnstableOnStoredModel: return "unstable on the stored model";
    case UpdateVerdict::kGainsTooLarge: return "gains too large";
    case UpdateVerdict::kGainsChangeFast: return "gains change fast";
    case UpdateVerdict::kErrorTooLarge: return "prediction error too large";
    case UpdateVerdict::kErrorNotWhite: return "prediction error not white";
    case UpdateVerdict::kMarginTooSmall: return "margin too small";
    case UpdateVerdict::kDwellTooLong: return "dwell time too long";
    case UpdateVerdict::kDwelling: return "dwelling";
  }
  return "unknown verdict";
}

}  // namespace farrier::signals
