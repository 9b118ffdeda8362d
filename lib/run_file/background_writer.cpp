#include "run_file/background_writer.hpp"

#include <chrono>

#include "runtime/realtime_thread.hpp"

namespace farrier::run_file {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kWorthWriting = 256u << 10;
constexpr auto kLongestWait = 1s;  // what a crash may take from slow streams

}  // namespace

void BackgroundWriter::Waiting::clear() {
  samples.clear();
  ends.clear();
  bytes.clear();
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
    if (waiting_.bytes.size() + sample.cdr.size() > most_waiting_bytes_ || !failure_.empty()) {
      ++dropped_[static_cast<std::size_t>(sample.topic)];
      return false;
    }
    waiting_.samples.push_back(sample);
    waiting_.bytes.insert(waiting_.bytes.end(), sample.cdr.begin(), sample.cdr.end());
    waiting_.ends.push_back(waiting_.bytes.size());
    much = waiting_.bytes.size() >= kWorthWriting;
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
                           [this] { return stopping_ || waiting_.bytes.size() >= kWorthWriting; });
      last = stopping_;
      std::swap(writing, waiting_);
    }
    const bool slow = writing.bytes.size() < kWorthWriting;
    write(writing);
    writing.clear();
    if (slow) {
      file_.flush();
    }
    const std::scoped_lock lock(mutex_);
    bytes_ = file_.bytes();
    failure_ = file_.failure();
  }
}

void BackgroundWriter::write(Waiting& waiting) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < waiting.samples.size(); ++i) {
    Sample& sample = waiting.samples[i];
    sample.cdr = std::span<const std::uint8_t>(waiting.bytes).subspan(begin, waiting.ends[i] - begin);
    begin = waiting.ends[i];
    file_.write(sample);
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

}  // namespace farrier::run_file
