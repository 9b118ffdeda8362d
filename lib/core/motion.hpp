#pragma once

// Words for the motion of the whole robot. Their numbers are sent and recorded, so they must not change.

#include <cstdint>

namespace farrier {

/// State of motion that an operator asks for. Locomotion passes through the states between by itself.
enum class MotionRequest : std::uint8_t {
  kLie = 0,  ///< lie on folded legs
  kStand = 1,
  kTrot = 2,  ///< trot at the commanded velocity, which may be zero
};

/// State of motion of the robot.
enum class MotionMode : std::uint8_t {
  kLie = 0,      ///< pose control; the first seconds are the soft start
  kStandUp = 1,  ///< the feet take the load, then the trunk rises
  kStand = 2,
  kTrot = 3,
  kStop = 4,     ///< brakes, steps in place, then stands
  kSitDown = 5,  ///< the trunk sinks, then the pose takes the load
  kFallen = 6,   ///< joints damp; left by a new controller only
};

constexpr const char* to_string(MotionRequest request) noexcept {
  switch (request) {
    case MotionRequest::kLie:
      return "lie";
    case MotionRequest::kStand:
      return "stand";
    case MotionRequest::kTrot:
      return "trot";
  }
  return "unknown request";
}

constexpr const char* to_string(MotionMode mode) noexcept {
  switch (mode) {
    case MotionMode::kLie:
      return "lie";
    case MotionMode::kStandUp:
      return "stand up";
    case MotionMode::kStand:
      return "stand";
    case MotionMode::kTrot:
      return "trot";
    case MotionMode::kStop:
      return "stop";
    case MotionMode::kSitDown:
      return "sit down";
    case MotionMode::kFallen:
      return "fallen";
  }
  return "unknown mode";
}

/// True for a number that one of the requests has.
constexpr bool known(MotionRequest request) noexcept { return request <= MotionRequest::kTrot; }

}  // namespace farrier
