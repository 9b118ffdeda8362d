#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "mcap/bytes.hpp"
#include "mcap/chunk.hpp"
#include "mcap/compression.hpp"
#include "mcap/records.hpp"

namespace farrier::mcap {

/// Writes an MCAP file: messages gather in a chunk, which goes to the file compressed, with CRC and index, when it is
/// full. After a crash the file is readable up to the last chunk that was written. Not for a control loop: writing
/// waits for the disk.
class Writer {
 public:
  static constexpr std::size_t kChunkBytes = 1u << 20;

  /// Refuses a path that cannot be written, and a file that another Writer has open. `library` names the program, for people.
  static Result<Writer> create(const std::string& path, const std::string& profile, const std::string& library,
                               std::size_t chunk_bytes = kChunkBytes);

  /// Returns its id.
  std::uint16_t add_schema(Schema schema);
  std::uint16_t add_channel(Channel channel);

  /// `message.channel_id` is one of add_channel's.
  void write(const Message& message);
  /// Writes a chunk of messages that was gathered elsewhere; nothing if it is empty.
  void write(const Chunk& chunk);
  void write(const Metadata& metadata);

  /// Sends the messages so far to the file, so that a later crash cannot lose them.
  void flush();

  /// Ends the file with its summary. Refuses if the disk has not taken all bytes since create.
  Result<Done> finish();

  /// True if the disk has refused bytes: nothing is written any more.
  bool failed() const noexcept { return !failure_.empty(); }
  const std::string& failure() const noexcept { return failure_; }
  std::uint64_t bytes() const noexcept { return offset_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };
  struct MetadataIndex {
    std::uint64_t offset;
    std::uint64_t length;
    std::string name;
  };

  Writer(std::FILE* file, std::string path, std::size_t chunk_bytes)
      : file_(file), path_(std::move(path)), chunk_bytes_(chunk_bytes) {}

  void put(std::span<const std::uint8_t> bytes);
  void put_chunk(const Chunk& chunk);
  void flush_file();
  std::map<std::uint16_t, std::uint64_t> put_message_indexes(const Chunk& chunk);
  void put_summary();

  std::unique_ptr<std::FILE, Close> file_;
  std::string path_;
  std::size_t chunk_bytes_;
  std::string failure_;
  std::uint64_t offset_ = 0;
  std::uint32_t data_crc_ = 0;  // of the data section so far
  Compressor compressor_;

  Chunk gathering_;
  ByteWriter scratch_;  // a record on its way to the file

  std::vector<Schema> schemas_;
  std::vector<Channel> channels_;
  std::vector<ChunkIndex> chunks_;
  std::vector<MetadataIndex> metadata_;
  Statistics statistics_;
};

}  // namespace farrier::mcap
