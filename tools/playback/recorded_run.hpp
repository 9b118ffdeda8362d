#pragma once

#include <string>

#include "robot/robot.hpp"
#include "recording/recording_file.hpp"

namespace farrier::playback {

/// True if a file begins as MCAP does; false for one that cannot be read.
bool is_recording(const std::string& path);

/// A recording, with the robot that it names.
class RecordedRun {
 public:
  /// Refuses if recording::RunFileReader does, a file without samples, one that does not name its robot anywhere, and
  /// when `keep_on` does. `overrides` change that robot. `keep_on` is called until the last sample.
  static Result<RecordedRun> open(const std::string& path, const robot::Overrides& overrides = {}, KeepOn keep_on = {});

  const robot::Robot& robot() const noexcept { return robot_; }

  /// recording::kRunFacts
  const mcap::Text& facts() const noexcept { return facts_; }

  /// Reads the next sample, valid until the next call. Returns false at the end: see `ending`.
  bool next(recording::Sample& sample);

  /// As of recording::RunFileReader.
  const std::string& ending() const noexcept { return file_.ending(); }
  const recording::Timeline& timeline() const noexcept { return file_.timeline(); }

 private:
  RecordedRun(recording::RunFileReader file, robot::Robot robot, mcap::Text facts, const recording::Sample& first)
      : file_(std::move(file)), robot_(std::move(robot)), facts_(std::move(facts)), first_(first) {}

  recording::RunFileReader file_;
  robot::Robot robot_;
  mcap::Text facts_;
  recording::Sample first_;  ///< read in advance: the facts before it are then known
  bool first_is_next_ = true;
};

}  // namespace farrier::playback
