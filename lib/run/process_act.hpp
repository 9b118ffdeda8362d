#pragma once

namespace farrier::run {

/// A process that listens to every stream (farrier echo) once it is started. It is no member of a run.
inline constexpr const char* kMonitor = "monitor";

/// Acts in place of a signal. kStart starts the process again, kStartTwin a second time while it runs. The other two
/// set the wall clock of the computer that all processes run on: an hour forward, or back to an hour before what it
/// was.
inline constexpr int kStart = 0;
inline constexpr int kStartTwin = -1;
inline constexpr int kClockForward = -2;
inline constexpr int kClockBack = -3;
inline constexpr bool sets_clock(int signal) noexcept { return signal == kClockForward || signal == kClockBack; }

/// An act on a process, `at_s` after a fault begins. Members are named as in plan_members; "joint_node" is the one that
/// hosts the joint.
struct ProcessAct {
  const char* member;
  int signal;  ///< or one of the above
  double at_s;
};

}  // namespace farrier::run
