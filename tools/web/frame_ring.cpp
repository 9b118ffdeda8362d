#include "tools/web/frame_ring.hpp"

#include <algorithm>
#include <utility>

namespace farrier::web {

void FrameRing::put(std::string frame, const std::vector<std::string>& events) {
  auto text = std::make_shared<const std::string>(std::move(frame));
  {
    const std::lock_guard lock(mutex_);
    frames_.push_back(std::move(text));
    if (frames_.size() > most_frames_) {
      frames_.pop_front();
      ++first_;
    }
    for (const std::string& event : events) {
      events_.push_back(std::make_shared<const std::string>(event));
    }
    while (events_.size() > most_events_) {
      events_.pop_front();
    }
  }
  news_.notify_all();
}

FrameRing::Piece FrameRing::read(std::uint64_t from, std::size_t most, std::chrono::milliseconds longest) {
  std::unique_lock lock(mutex_);
  from = std::min(from, first_ + frames_.size());
  news_.wait_for(lock, longest, [&] { return closed_ || first_ + frames_.size() > from; });
  Piece piece;
  piece.closed = closed_;
  piece.next = std::max(from, first_);
  piece.passed_over = piece.next - from;
  if (piece.passed_over > 0) {
    piece.events.assign(events_.begin(), events_.end());
  }
  for (std::size_t i = piece.next - first_; i < frames_.size() && piece.frames.size() < most; ++i) {
    piece.frames.push_back(frames_[i]);
  }
  piece.next += piece.frames.size();
  return piece;
}

void FrameRing::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  news_.notify_all();
}

}  // namespace farrier::web
