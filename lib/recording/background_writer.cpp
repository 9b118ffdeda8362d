#include "recording/background_writer.hpp"

#include <algorithm>
#include <chrono>

#include "runtime/realtime_thread.hpp"

namespace farrier::recording {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kKeptChunks = 2;  // whose memory is kept: one is written while the other gathers
constexpr auto kLongestWait = 1s;       // what a crash may take from slow streams

}  // namespace

void BackgroundWriter::Waiting::add(const Sample& sample) {
  if (used == 0 || chunks[used - 1].size() >= RunFileWriter::kChunkBytes) {
    ++used;
    chunks.resize(std::max(chunks.size(), used));
  }
  mcap::Chunk& last = chunks[used - 1];
  const std::size_t before = last.size();
  last.write(message_of(sample));
  bytes += last.size() - before;
}

void BackgroundWriter::Waiting::clear() {
  chunks.resize(std::min(chunks.size(), kKeptChunks));
  for (mcap::Chunk& chunk : chunks) {
    chunk.clear();
  }
  used = bytes = 0;
}

BackgroundWriter::BackgroundWriter(RunFileWriter file, std::size_t most_waiting_bytes)
    : most_waiting_bytes_(most_waiting_bytes),
      failure_(file.failure()),
      file_(std::move(file)),
      thread_([this] { run(); }) {}

BackgroundWriter::~BackgroundWriter() { stop(); }

bool BackgroundWriter::offer(const Sample& sample) {
  bool much = false;
  {
    const std::scoped_lock lock(mutex_);
    if (waiting_.bytes + sample.cdr.size() > most_waiting_bytes_ || !failure_.empty()) {
      ++dropped_[static_cast<std::size_t>(sample.topic)];
      return false;
    }
    const bool already = waiting_.bytes >= RunFileWriter::kChunkBytes;
    waiting_.add(sample);
    much = !already && waiting_.bytes >= RunFileWriter::kChunkBytes;
  }
  if (much) {
    much_waits_.notify_one();
  }
  return true;
}

void BackgroundWriter::run() {
  runtime::give_way();
  Waiting writing;
  for (bool last = false; !last;) {
    {
      std::unique_lock lock(mutex_);
      much_waits_.wait_for(lock, kLongestWait,
                           [this] { return stopping_ || waiting_.bytes >= RunFileWriter::kChunkBytes; });
      last = stopping_;
      std::swap(writing, waiting_);
    }
    for (std::size_t i = 0; i < writing.used; ++i) {
      file_.write(writing.chunks[i]);
    }
    writing.clear();
    const std::scoped_lock lock(mutex_);
    bytes_ = file_.bytes();
    failure_ = file_.failure();
  }
}

void BackgroundWriter::stop() {
  if (!thread_.joinable()) {
    return;
  }
  {
    const std::scoped_lock lock(mutex_);
    stopping_ = true;
  }
  much_waits_.notify_one();
  thread_.join();
}

Result<Done> BackgroundWriter::finish(const TopicCounts& lost_before) {
  stop();
  TopicCounts lost = lost_before;
  for (std::size_t topic = 0; topic < lost.size(); ++topic) {
    lost[topic] += dropped_[topic];
  }
  return file_.finish(lost);
}

TopicCounts BackgroundWriter::dropped() const {
  const std::scoped_lock lock(mutex_);
  return dropped_;
}

std::uint64_t BackgroundWriter::bytes() const {
  const std::scoped_lock lock(mutex_);
  return bytes_;
}

std::string BackgroundWriter::failure() const {
  const std::scoped_lock lock(mutex_);
  return failure_;
}

}  // namespace farrier::recording
