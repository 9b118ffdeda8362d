#pragma once

// The records of an MCAP file that Farrier writes and reads: https://mcap.dev/spec, version 0.

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace farrier::mcap {

inline constexpr std::array<std::uint8_t, 8> kMagic = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

enum class Opcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0a,
  kStatistics = 0x0b,
  kMetadata = 0x0c,
  kMetadataIndex = 0x0d,
  kSummaryOffset = 0x0e,
  kDataEnd = 0x0f,
};

using Text = std::map<std::string, std::string>;

/// Layout of the messages of channels, for readers that know nothing of Farrier.
struct Schema {
  std::uint16_t id = 0;  ///< from 1 on
  std::string name;
  std::string encoding;  ///< such as "ros2idl"
  std::string data;
};

struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema_id = 0;
  std::string topic{};
  std::string message_encoding{};  ///< such as "cdr"
  Text metadata{};
  bool operator==(const Channel&) const = default;
};

struct Message {
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time_ns = 0;      ///< since 1970, when it was recorded
  std::uint64_t publish_time_ns = 0;  ///< since 1970, when it came to be
  std::span<const std::uint8_t> data;
};

struct Metadata {
  std::string name;
  Text values;
};

/// Place of a chunk in the file, and the range of its messages' times.
struct ChunkIndex {
  std::uint64_t first_ns = 0;
  std::uint64_t last_ns = 0;
  std::uint64_t offset = 0;
  std::uint64_t length = 0;                                ///< of the whole record
  std::map<std::uint16_t, std::uint64_t> index_offsets{};  ///< of each channel's message index
  std::uint64_t index_length = 0;
  std::string compression{};
  std::uint64_t compressed_size = 0;
  std::uint64_t uncompressed_size = 0;
};

struct Statistics {
  std::uint64_t messages = 0;
  std::uint16_t schemas = 0;
  std::uint32_t channels = 0;
  std::uint32_t attachments = 0;
  std::uint32_t metadata = 0;
  std::uint32_t chunks = 0;
  std::uint64_t first_ns = 0;
  std::uint64_t last_ns = 0;
  std::map<std::uint16_t, std::uint64_t> messages_of;  ///< by channel
};

}  // namespace farrier::mcap
