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
#include "recording/timeline.hpp"

namespace farrier::recording {

/// One sample, as it is written and read.
struct Sample {
  bus::TopicId topic{};
  std::uint32_t sequence = 0;         ///< lower half of signals::sequence_of; 0: has none
  std::uint64_t log_time_ns = 0;      ///< since 1970: when the recorder had it
  std::uint64_t publish_time_ns = 0;  ///< since 1970: when what it says was true
  std::span<const std::uint8_t> cdr;  ///< signals::to_cdr
  std::uint64_t elapsed_ns = 0;       ///< by RunFileReader alone: since the first sample, without steps of the clock
};

/// Gets samples, which are valid for the call.
using TakeSample = std::function<void(const Sample&)>;

/// Names of the metadata records of a recording.
inline constexpr const char* kRunFacts = "farrier.run";  ///< robot, file, vendor, clock, revision, seed: see docs
inline constexpr const char* kLosses = "farrier.lost";   ///< by topic, samples that the recording does not have

/// Name of a topic's version in the metadata of its channel.
inline constexpr const char* kVersionOfTopic = "version";

/// The ending of a file whose reading was stopped.
inline constexpr const char* kInterrupted = mcap::kInterrupted;

using TopicCounts = std::array<std::uint64_t, bus::kTopicCount>;

/// As a file has it.
mcap::Message message_of(const Sample& sample) noexcept;

/// Path of a recording until it is finished, and afterwards if it never is: readable up to its last whole chunk.
/// Devices and pipes are written in place.
std::string path_while_written(const std::string& path);

/// Refuses a path that has a file, and one beside which an earlier recorder left the part of a recording.
Result<Done> refuse_existing(const std::string& path);

/// Last part of the reason why a run broke off: "; what was recorded is in run.mcap.part". Empty for no path.
std::string left_behind(const std::string& path);

class RunFileWriter {
 public:
  static constexpr std::size_t kChunkBytes = mcap::Writer::kChunkBytes;

  /// Writes to path_while_written(path), which is emptied. Refuses a path that cannot be written, and one that another
  /// recorder writes.
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

/// Messages of one topic of another program in a file.
struct ForeignTopic {
  std::string type;      ///< name of its schema; may be empty
  std::string encoding;  ///< of its messages, such as "cdr"
  std::uint64_t messages = 0;
};

/// The one reader of recordings. Bytes that are no sample of their topic, and samples of another version of it, are
/// counted and left out, like damaged parts of the file; the rest is read, and `ending` names them.
class RunFileReader {
 public:
  /// Refuses a file that cannot be read or is not MCAP.
  static Result<RunFileReader> open(const std::string& path);

  /// `keep_on` is called as mcap::Reader does until the last sample. If it returns false the file ends, with
  /// kInterrupted.
  void ask(KeepOn keep_on) { file_.ask(std::move(keep_on)); }

  /// Reads the next sample, valid until the next call. Skips messages of other programs and topics that this version
  /// does not know. Returns false at the end: see `ending`.
  bool next(Sample& sample);

  /// Empty: the file was read to its regular end, and all of it was good. Otherwise the reason why not.
  const std::string& ending() const noexcept { return ending_; }
  /// Returns a metadata record read so far; empty without one. kLosses comes at the end.
  mcap::Text metadata(const std::string& name) const;
  const mcap::Reader& file() const noexcept { return file_; }

  /// Samples read, and those that were left out because their bytes are not of their topic.
  std::uint64_t samples() const noexcept { return samples_; }
  std::uint64_t damaged_samples() const noexcept { return damaged_; }
  /// By name, what was left out because it is of another program.
  const std::map<std::string, ForeignTopic>& foreign() const noexcept { return foreign_; }
  /// Steps of the clock of day, as far as the file is read.
  const Timeline& timeline() const noexcept { return timeline_; }
  /// A sentence about a file that was read to its end and has nothing of Farrier in it, with what it has. Empty
  /// otherwise.
  std::string nothing_of_farrier() const;

 private:
  explicit RunFileReader(mcap::Reader file, std::string path) : file_(std::move(file)), path_(std::move(path)) {}

  bool read(Sample& sample);
  /// Samples of a topic in another version.
  struct OtherVersion {
    std::string version;
    std::uint64_t samples = 0;
  };
  /// Meaning of a channel. Without a topic it is of another program.
  struct Meaning {
    const bus::TopicSpec* topic = nullptr;
    OtherVersion* other = nullptr;  ///< null: the version is this program's
  };

  Meaning meaning_of(std::uint16_t channel);
  void count_foreign(std::uint16_t channel);
  void leave_out(const Sample& sample);
  void end();

  mcap::Reader file_;
  std::string path_;
  std::map<std::uint16_t, Meaning> meanings_;   // by channel
  std::uint64_t redefinitions_ = 0;             // of channels, when meanings_ was true
  std::map<std::string, OtherVersion> others_;  // by topic
  Timeline timeline_;
  std::uint64_t samples_ = 0, damaged_ = 0;
  std::string first_damaged_;
  std::map<std::string, ForeignTopic> foreign_;
  std::string ending_;
  bool ended_ = false;
};

}  // namespace farrier::recording
