#pragma once

#include <string>

#include "robot/robot.hpp"
#include "run_file/run_file.hpp"

namespace farrier::recording {

/// Whether a file begins as MCAP does; false for one that cannot be read.
bool is_recording(const std::string& path);

/// A recording, with the robot that it says it is of.
class RecordedRun {
 public:
  /// Refuses what run_file::RunFileReader does, a file without samples, and one that does not say of which robot it is.
  /// `overrides` change that robot.
  static Result<RecordedRun> open(const std::string& path, const robot::Overrides& overrides = {});

  const robot::Robot& robot() const noexcept { return robot_; }

  /// As run_file::RunFileReader.
  void ask(KeepOn keep_on) { file_.ask(std::move(keep_on)); }

  /// The next sample, valid until the next call. False at the end: see `ending`.
  bool next(run_file::Sample& sample);

  /// Empty: the file was read to its regular end. Otherwise why not.
  const std::string& ending() const noexcept { return file_.ending(); }

 private:
  RecordedRun(run_file::RunFileReader file, robot::Robot robot, const run_file::Sample& first)
      : file_(std::move(file)), robot_(std::move(robot)), first_(first) {}

  run_file::RunFileReader file_;
  robot::Robot robot_;
  run_file::Sample first_;  ///< facts come before samples: to have the ones the other must be read
  bool first_is_next_ = true;
};

}  // namespace farrier::recording
