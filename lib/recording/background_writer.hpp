#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "recording/recording_file.hpp"

namespace farrier::recording {

/// Writes a run file on a thread of its own. A thread that offers samples never waits for the disk. Samples that do not
/// fit into the memory of the queue are lost, and counted.
class BackgroundWriter {
 public:
  static constexpr std::size_t kMostWaitingBytes = 64u << 20;

  explicit BackgroundWriter(RunFileWriter file, std::size_t most_waiting_bytes = kMostWaitingBytes);
  /// Without a finish before, the file stays at path_while_written, readable up to the last written chunk.
  ~BackgroundWriter();
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  /// Copies the sample. Returns false if it is lost, because the disk is behind or refuses.
  bool offer(const Sample& sample);

  /// Writes waiting samples, ends the file and gives it its name. `lost_before`: samples that never came to `offer`.
  /// Refuses if the disk did not take everything. Nothing may be offered after it.
  Result<Done> finish(const TopicCounts& lost_before);

  /// Lost in `offer`, by topic.
  TopicCounts dropped() const;
  /// Size of the file so far.
  std::uint64_t bytes() const;
  /// Why the disk refuses; empty: it does not.
  std::string failure() const;

 private:
  /// Chunks that wait, the last of which gathers.
  struct Waiting {
    std::vector<mcap::Chunk> chunks;
    std::size_t used = 0;   // of them; the others keep their memory
    std::size_t bytes = 0;  // in all
    void add(const Sample& sample);
    void clear();
  };

  void run();
  void stop();

  const std::size_t most_waiting_bytes_;
  mutable std::mutex mutex_;
  std::condition_variable much_waits_;
  Waiting waiting_;
  TopicCounts dropped_{};
  std::uint64_t bytes_ = 0;
  std::string failure_;
  bool stopping_ = false;
  RunFileWriter file_;  // of the thread, until it has ended
  std::thread thread_;
};

}  // namespace farrier::recording
