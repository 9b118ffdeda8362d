#pragma once

// MCAP files as any writer may make them, record by record.

#include <cstdint>
#include <string>
#include <vector>

#include "bus/topics.hpp"
#include "mcap/bytes.hpp"
#include "mcap/record_bytes.hpp"
#include "robot/robot.hpp"

namespace farrier::test {

inline constexpr std::uint64_t kBegin_ns = 1'700'000'000'000'000'000;  ///< a log time in 2023

/// The robot of these files, a rig of one joint.
const robot::Robot& leg();

/// One sample of a topic, to be put into a file.
struct PlacedSample {
  bus::TopicId topic{};
  std::uint32_t sequence = 0;
  std::uint64_t log_time_ns = 0;
  std::vector<std::uint8_t> cdr{};
};

/// Samples of a bench run: measurements of every joint and tick, and summaries of 20 ticks. `begin_ns`: log time of
/// tick 0.
std::vector<PlacedSample> bench_samples(const robot::Robot& robot, Tick ticks, std::uint64_t begin_ns);

enum class Packing {
  kNone,
  kZstd,
  kZstdWithoutSize,  ///< as a writer makes it that compresses a stream
  kZstdFrames,       ///< two frames, without their sizes
  kLz4,
};

/// Channel of a topic, as farrier record describes it.
mcap::Channel channel_of(bus::TopicId topic, std::uint16_t id);

class AnyMcap {
 public:
  AnyMcap();

  /// Into the present chunk.
  void put(const mcap::Schema& schema) { append(chunk_, schema); }
  void put(const mcap::Channel& channel) { append(chunk_, channel); }
  void put(const mcap::Message& message) { append(chunk_, message); }
  void put(std::uint16_t channel, const PlacedSample& sample);
  mcap::ByteWriter& chunk() noexcept { return chunk_; }

  /// Writes the present chunk. `crc`: that of its bytes unless given.
  void close_chunk(Packing packing, std::uint32_t crc = 0);
  /// The same as records outside chunks.
  void close_loose();

  void put_metadata(const mcap::Metadata& metadata);
  /// Records with a content of `size` zeros, which take no room on the disk.
  void put_attachment(std::uint64_t size);
  void put_large_metadata(std::uint64_t size);
  void put_large_message(std::uint16_t channel, std::uint64_t size);
  /// A chunk that claims to have that many bytes and has them, all zeros.
  void put_large_chunk(std::uint64_t size);
  void put_data_end();
  void put_footer();

  void save(const std::string& path) const;

 private:
  struct Piece {
    std::vector<std::uint8_t> bytes;
    std::uint64_t hole = 0;  ///< zeros behind them
  };
  mcap::ByteWriter& open_piece() noexcept { return file_; }
  void put_with_hole(mcap::Opcode opcode, std::span<const std::uint8_t> head, std::uint64_t hole,
                     std::span<const std::uint8_t> tail);

  mcap::ByteWriter file_;  // since the last hole
  std::vector<Piece> pieces_;
  mcap::ByteWriter chunk_;
};

/// The whole of a run in one file: channels, facts, samples in chunks of some hundred.
AnyMcap ordinary_file(const robot::Robot& robot, const std::vector<PlacedSample>& samples, Packing packing);

}  // namespace farrier::test
