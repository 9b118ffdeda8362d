#pragma once

// A run on disk: every sample of every topic in MCAP, as it is on the wire, with its IDL.

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bus/topics.hpp"
#include "core/keep_on.hpp"
#include "core/result.hpp"
#include "mcap/reader.hpp"
#include "mcap/writer.hpp"

namespace farrier::recording {

/// One sample, as it is written and read.
struct Sample {
  bus::TopicId topic{};
  std::uint32_t sequence = 0;        ///< lower half of signals::sequence_of; 0: has none
  std::uint64_t log_time_ns = 0;     ///< since 1970: when the recorder had it
  std::uint64_t publish_time_ns = 0; ///< since 1970: when what it says was true
  std::span<const std::uint8_t> cdr; ///< signals::to_cdr
};

/// Gets samples, which are valid for the call.
using TakeSample = std::function<void(const Sample&)>;

/// Names of the metadata records of a recording.
inline constexpr const char* kRunFacts = "farrier.run";    ///< robot, file, vendor, clock, revision, seed: see docs
inline constexpr const char* kLosses = "farrier.lost";     ///< by topic, samples that the recording does not have

/// The ending of a file whose reading was stopped.
inline constexpr const char* kInterrupted = "interrupted";

using TopicCounts = std::array<std::uint64_t, bus::kTopicCount>;

/// As a file has it.
mcap::Message message_of(const Sample& sample) noexcept;

/// Path of a recording until it is finished, and afterwards if it never is: readable up to its last whole chunk.
/// Devices and pipes are written in place.
std::string path_while_written(const std::string& path);

/// Last part of the reason why a run broke off: "; what was recorded is in run.mcap.part". Empty for no path.
std::string left_behind(const std::string& path);

class RunFileWriter {
 public:
  static constexpr std::size_t kChunkBytes = mcap::Writer::kChunkBytes;

  /// Writes to path_while_written(path). Refuses a path that cannot be written.
  static Result<RunFileWriter> create(const std::string& path, const mcap::Text& facts);

  void write(const Sample& sample);
  /// A chunk of messages, each message_of a sample.
  void write(const mcap::Chunk& chunk) { file_.write(chunk); }
  /// Sends what is buffered to the file.
  void flush() { file_.flush(); }
  /// Ends the file and gives it its name, in place of the file that has it. Refuses when the disk did not take everything.
  Result<Done> finish(const TopicCounts& lost);

  bool failed() const noexcept { return file_.failed(); }
  const std::string& failure() const noexcept { return file_.failure(); }
  std::uint64_t bytes() const noexcept { return file_.bytes(); }

 private:
  RunFileWriter(mcap::Writer file, std::string path) : file_(std::move(file)), path_(std::move(path)) {}

  mcap::Writer file_;
  std::string path_;  ///< that it gets; empty: it has its name
};

class RunFileReader {
 public:
  /// Refuses a file that cannot be read, is not MCAP or is not of Farrier. A topic of another contract ends the reading
  /// at its first sample, with the reason in `ending`.
  static Result<RunFileReader> open(const std::string& path);

  /// `keep_on` is called at every chunk until the last sample. If it returns false the file ends, with kInterrupted.
  void ask(KeepOn keep_on) { keep_on_ = std::move(keep_on); }

  /// Reads the next sample, valid until the next call. Skips samples of topics that this version does not know. Returns
  /// false at the end: see `ending`.
  bool next(Sample& sample);

  /// Empty: the file was read to its regular end. Otherwise the reason why not.
  const std::string& ending() const noexcept { return ending_.empty() ? file_.ending() : ending_; }
  /// Returns a metadata record read so far; empty without one. kLosses comes at the end.
  mcap::Text metadata(const std::string& name) const;
  const mcap::Reader& file() const noexcept { return file_; }

 private:
  explicit RunFileReader(mcap::Reader file) : file_(std::move(file)) {}

  bool keeps_on();
  bool read(Sample& sample);

  mcap::Reader file_;
  KeepOn keep_on_;
  std::uint64_t asked_ = 0;  // when so many chunks were read
  std::map<std::uint16_t, const bus::TopicSpec*> topics_;  // by channel; null: not of this version
  std::string ending_;
};

}  // namespace farrier::recording
