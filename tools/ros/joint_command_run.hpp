#pragma once

#include <memory>
#include <string>
#include <thread>

#include "monitor/frame.hpp"
#include "participant/options.hpp"
#include "tools/ros/joint_command_source.hpp"

namespace farrier::ros_bridge {

/// The thread in which this process takes the part of locomotion, in each run that begins without one.
class JointCommandRun {
 public:
  /// `options`: robot, vendor, network and security of the run. The rest comes from the run itself.
  JointCommandRun(participant::ProcessOptions options, JointCommandReaders readers, Nanoseconds timeout);
  ~JointCommandRun();
  JointCommandRun(const JointCommandRun&) = delete;
  JointCommandRun& operator=(const JointCommandRun&) = delete;

  /// Looks who greets. Joins a run when its launcher is heard, and leaves it when another one has begun. `participants`:
  /// processes of the run, where no launcher says it; 0: the launcher does. Returns a sentence about why it cannot join, or
  /// an empty text.
  std::string look(const monitor::Frame& frame, int participants);

  /// True if joints get commands now.
  bool commands() const noexcept { return state_.commands; }

  NoticeQueue& notices() noexcept { return state_.notices; }

 private:
  void join(std::uint64_t session, int participants);
  void leave();

  participant::ProcessOptions options_;
  JointCommandReaders readers_;
  Nanoseconds timeout_;
  JointCommandState state_;
  std::uint64_t session_ = 0;  ///< of the run it has joined; 0: none
  std::thread thread_;
};

}  // namespace farrier::ros_bridge
