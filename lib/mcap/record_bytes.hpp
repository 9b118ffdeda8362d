#pragma once

#include <optional>

#include "mcap/bytes.hpp"

namespace farrier::mcap {

inline void append(ByteWriter& out, const Schema& schema) {
  out.record(Opcode::kSchema, [&] {
    out.number(schema.id);
    out.text(schema.name);
    out.text(schema.encoding);
    out.text(schema.data);
  });
}

inline void append(ByteWriter& out, const Channel& channel) {
  out.record(Opcode::kChannel, [&] {
    out.number(channel.id);
    out.number(channel.schema_id);
    out.text(channel.topic);
    out.text(channel.message_encoding);
    out.map(channel.metadata);
  });
}

inline void append(ByteWriter& out, const Message& message) {
  out.record(Opcode::kMessage, [&] {
    out.number(message.channel_id);
    out.number(message.sequence);
    out.number(message.log_time_ns);
    out.number(message.publish_time_ns);
    out.bytes(message.data);
  });
}

inline void append(ByteWriter& out, const Metadata& metadata) {
  out.record(Opcode::kMetadata, [&] {
    out.text(metadata.name);
    out.map(metadata.values);
  });
}

inline void append(ByteWriter& out, const ChunkIndex& chunk) {
  out.record(Opcode::kChunkIndex, [&] {
    out.number(chunk.first_ns);
    out.number(chunk.last_ns);
    out.number(chunk.offset);
    out.number(chunk.length);
    out.map(chunk.index_offsets);
    out.number(chunk.index_length);
    out.text(chunk.compression);
    out.number(chunk.compressed_size);
    out.number(chunk.uncompressed_size);
  });
}

inline void append(ByteWriter& out, const Statistics& statistics) {
  out.record(Opcode::kStatistics, [&] {
    out.number(statistics.messages);
    out.number(statistics.schemas);
    out.number(statistics.channels);
    out.number(statistics.attachments);
    out.number(statistics.metadata);
    out.number(statistics.chunks);
    out.number(statistics.first_ns);
    out.number(statistics.last_ns);
    out.map(statistics.messages_of);
  });
}

inline Schema read_schema(ByteReader in) {
  Schema schema;
  schema.id = in.number<std::uint16_t>();
  schema.name = in.text();
  schema.encoding = in.text();
  schema.data = in.text();
  return schema;
}

/// Empty for bytes that are no channel.
inline std::optional<Channel> read_channel(ByteReader in) {
  Channel channel;
  channel.id = in.number<std::uint16_t>();
  channel.schema_id = in.number<std::uint16_t>();
  channel.topic = in.text();
  channel.message_encoding = in.text();
  channel.metadata = in.text_map();
  return in.good() ? std::optional(std::move(channel)) : std::nullopt;
}

inline Message read_message(ByteReader in) {
  Message message;
  message.channel_id = in.number<std::uint16_t>();
  message.sequence = in.number<std::uint32_t>();
  message.log_time_ns = in.number<std::uint64_t>();
  message.publish_time_ns = in.number<std::uint64_t>();
  message.data = in.rest();
  return message;
}

inline Metadata read_metadata(ByteReader in) {
  Metadata metadata;
  metadata.name = in.text();
  metadata.values = in.text_map();
  return metadata;
}

}  // namespace farrier::mcap
