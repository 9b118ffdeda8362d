#pragma once

// Meanings of the codes in signals. Their numbers are sent and recorded, so they must not change.

#include <cstdint>

#include "core/motion.hpp"
#include "core/phase.hpp"

namespace farrier::signals {

using farrier::kPhaseCount;
using farrier::MotionMode;
using farrier::MotionRequest;
using farrier::Phase;

/// Number of a joint in an event that is not about one joint.
inline constexpr std::uint16_t kNoJoint = 0xffff;

/// Modes of the whole robot; the supervisor publishes them.
enum class Mode : std::uint8_t { kIdle = 0, kArmed = 1, kStopped = 2 };

/// Requests of an operator.
enum class Request : std::uint8_t { kArm = 0, kStop = 1 };

/// Activity of one joint (precedence from the bottom of the table in docs/architecture.md).
enum class JointState : std::uint8_t { kNull = 0, kDamping = 1, kTracking = 2 };

enum class Severity : std::uint8_t { kInfo = 0, kWarning = 1, kError = 2 };

/// Verdict of the update logic on an estimate (Hubacher 2014, Section 5.3, Fig. 8.8, Table F.2).
enum class UpdateVerdict : std::uint8_t {
  kAccepted = 0,               ///< new gains are issued
  kNotDifferentEnough = 1,     ///< poles too near those the acting gains are designed for
  kNotConverged = 2,           ///< poles still move
  kNotValid = 3,               ///< the estimate says too little
  kDesignRefused = 4,          ///< no controller exists for the estimate
  kUnstableOnEstimate = 5,     ///< the new closed loop is not stable on the estimate within its errors
  kUnstableOnStoredModel = 6,  ///< nor on the stored model within its stated uncertainty
  kGainsTooLarge = 7,          ///< new gains beyond their bounds
  kGainsChangeFast = 8,        ///< new gains not yet at rest from estimate to estimate
  kErrorTooLarge = 9,          ///< predictions too far off
  kErrorNotWhite = 10,         ///< prediction errors still hold something to be learnt
  kMarginTooSmall = 11,        ///< the new loop's disk or delay margin below its bound
  kDwellTooLong = 12,          ///< the joint's two loops would need to stay longer than a phase lasts
  kDwelling = 13,              ///< the joint's last gains have not acted as long as they must
};

using farrier::to_string;
const char* to_string(Mode mode) noexcept;
const char* to_string(Request request) noexcept;
const char* to_string(JointState state) noexcept;
const char* to_string(Severity severity) noexcept;
const char* to_string(UpdateVerdict verdict) noexcept;

}  // namespace farrier::signals
