#pragma once

#include <string>
#include <vector>

#include "core/keep_on.hpp"
#include "core/result.hpp"
#include "robot/robot.hpp"
#include "tools/web/web_server.hpp"

namespace farrier::web {

/// A recording as twenty frames a second, kept compressed in memory: an hour of HyQ is some ten megabytes.
class RecordedFrames {
 public:
  static constexpr double kFramesPerSecond = 20.0;

  /// Reads all of it. Refuses a file that is no recording of a robot, or has no summaries of its joints in it, and when
  /// `keep_on` does.
  static Result<RecordedFrames> read(const std::string& path, KeepOn keep_on = {});

  const robot::Robot& robot() const noexcept { return *robot_; }
  std::size_t count() const noexcept { return count_; }

  /// Length, number of frames, every event, when which joint had which faults. `opens_at_s` is where a page opens: the
  /// last frame with summaries among those in which most joints have been heard.
  const std::string& overview() const noexcept { return overview_; }

  /// Steps of the clock of day, which the frames leave out, and the reason if the file is not whole.
  const std::vector<std::string>& remarks() const noexcept { return remarks_; }

  /// Every `every`-th frame from number `from` until before `to`, as a JSON array; at most kMostAtOnce of them. Empty
  /// where there are none, or `every` is 0.
  std::string frames(std::size_t from, std::size_t to, std::size_t every = 1) const;
  static constexpr std::size_t kMostAtOnce = 400;

  /// As a site, which shares nothing with this.
  static Site site(std::shared_ptr<const RecordedFrames> frames, PageFiles page);

 private:
  class Maker;
  RecordedFrames() = default;

  std::shared_ptr<const robot::Robot> robot_;
  std::size_t count_ = 0;
  std::vector<std::string> blocks_;  ///< of kFramesPerBlock frames each, a line each, zstd
  std::string overview_;
  std::vector<std::string> remarks_;
};

}  // namespace farrier::web
