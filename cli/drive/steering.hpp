#pragma once

#include <string>

#include "locomotion/controller.hpp"
#include "locomotion/trunk_reference.hpp"

namespace farrier::cli {

/// The meanings of the keys of farrier drive.
enum class Key {
  kFaster,     ///< arrow up, w
  kSlower,     ///< arrow down, s; backwards beyond standstill
  kTurnLeft,   ///< arrow left, a
  kTurnRight,  ///< arrow right, d
  kLeft,       ///< comma
  kRight,      ///< full stop
  kStop,       ///< space: stops walking and stands
  kLie,        ///< l
  kEnd,        ///< q, Ctrl-C: lies down, then ends
  kNull,       ///< x: every valve to null at once
};

/// From keys to commands: each press changes the command by a step, within the limits of the robot file.
class Steering {
 public:
  explicit Steering(const locomotion::TrunkReferenceParams& limits) noexcept : limits_(limits) {}

  void press(Key key) noexcept;
  /// The terminal is gone: as kEnd.
  void lose_terminal() noexcept { press(Key::kEnd); }
  /// The state of motion of the robot, as locomotion tells it.
  void take(MotionMode mode) noexcept { mode_ = mode; }

  const locomotion::MotionCommand& command() const noexcept { return command_; }
  /// True when the robot is to lie down and the command then ends.
  bool ending() const noexcept { return ending_; }
  /// True when it lies, or has fallen, after it was asked to end.
  bool ended() const noexcept { return ending_ && (mode_ == MotionMode::kLie || mode_ == MotionMode::kFallen); }
  /// True once kNull was pressed.
  bool nulled() const noexcept { return nulled_; }

  /// Mode and command for people: "trot, forward 0.4 m/s, left 0 m/s, turning left 0.2 rad/s".
  std::string text() const;

 private:
  void walk(double forward_m_s, double left_m_s, double yaw_rate_rad_s) noexcept;

  locomotion::TrunkReferenceParams limits_;
  locomotion::MotionCommand command_;
  MotionMode mode_ = MotionMode::kLie;
  bool ending_ = false, nulled_ = false;
};

}  // namespace farrier::cli
