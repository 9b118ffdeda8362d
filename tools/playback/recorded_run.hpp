#pragma once

#include <string>

#include "robot/robot.hpp"
#include "recording/recording_file.hpp"

namespace farrier::playback {

/// Whether a file begins as MCAP does; false for one that cannot be read.
bool is_recording(const std::string& path);

/// A recording, with the robot that it says it is of.
class RecordedRun {
 public:
  /// Refuses what recording::RunFileReader does, a file without samples, and one that does not say of which robot it is.
  /// `overrides` change that robot.
  static Result<RecordedRun> open(const std::string& path, const robot::Overrides& overrides = {});

  const robot::Robot& robot() const noexcept { return robot_; }

  /// As recording::RunFileReader.
  void ask(KeepOn keep_on) { file_.ask(std::move(keep_on)); }

  /// The next sample, valid until the next call. False at the end: see `ending`.
  bool next(recording::Sample& sample);

  /// Empty: the file was read to its regular end. Otherwise why not.
  const std::string& ending() const noexcept { return file_.ending(); }

 private:
  RecordedRun(recording::RunFileReader file, robot::Robot robot, const recording::Sample& first)
      : file_(std::move(file)), robot_(std::move(robot)), first_(first) {}

  recording::RunFileReader file_;
  robot::Robot robot_;
  recording::Sample first_;  ///< facts come before samples: to have the ones the other must be read
  bool first_is_next_ = true;
};

}  // namespace farrier::playback
