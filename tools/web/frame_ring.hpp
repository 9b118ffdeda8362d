#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace farrier::web {

/// The newest frames and events of a robot, as text, for pages that each read at their own pace. A thread that adds a
/// frame never waits for a page; a page that is too far behind goes on with the oldest frame that is still here.
class FrameRing {
 public:
  using Text = std::shared_ptr<const std::string>;

  /// Answer to one request of a page.
  struct Piece {
    std::vector<Text> frames;        ///< in order
    std::uint64_t next = 0;          ///< number of the frame behind them: where to read on
    std::uint64_t passed_over = 0;   ///< frames before them that this page will never get
    std::vector<Text> events;        ///< all that are kept, where frames were passed over
    bool closed = false;             ///< there will be no more
  };

  /// Keeps so many frames and events.
  FrameRing(std::size_t frames, std::size_t events) : most_frames_(frames), most_events_(events) {}

  void put(std::string frame, const std::vector<std::string>& events);

  /// At most `most` frames from number `from` on; waits for one, at most `longest`.
  Piece read(std::uint64_t from, std::size_t most, std::chrono::milliseconds longest);

  /// Nobody waits any more.
  void close();

 private:
  const std::size_t most_frames_, most_events_;
  std::mutex mutex_;
  std::condition_variable news_;
  std::deque<Text> frames_;
  std::deque<Text> events_;
  std::uint64_t first_ = 0;  ///< number of frames_.front()
  bool closed_ = false;
};

}  // namespace farrier::web
