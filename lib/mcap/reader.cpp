#include "mcap/reader.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "mcap/compression.hpp"
#include "mcap/record_bytes.hpp"

namespace farrier::mcap {
namespace {

constexpr std::uint64_t kRecordHead = sizeof(std::uint8_t) + sizeof(std::uint64_t);

constexpr const char* kCutOff = "the file was cut off: it ends in the middle of a record";

}  // namespace

Result<Reader> Reader::open(const std::string& path) {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(path, error);
  Reader reader(path, size);
  if (error || !reader.file_) {
    return Error{"cannot read " + path + ": " + (error ? error.message() : std::strerror(errno))};
  }
  Opcode opcode{};
  if (!reader.read_magic() || !reader.read_record(opcode, reader.record_) || opcode != Opcode::kHeader) {
    return Error{path + ": not an MCAP file"};
  }
  ByteReader header(reader.record_);
  header.text();
  reader.library_ = header.text();
  return reader;
}

bool Reader::next(Message& message) {
  while (!ended_) {
    if (at_ == chunk_.size() && !read_next_chunk()) {
      break;
    }
    ByteReader in(std::span<const std::uint8_t>(chunk_).subspan(at_));
    const auto opcode = static_cast<Opcode>(in.number<std::uint8_t>());
    const std::span<const std::uint8_t> content = in.bytes(in.number<std::uint64_t>());
    if (!in.good()) {
      end("a chunk ends in the middle of a record");
      break;
    }
    at_ = chunk_.size() - in.rest().size();
    if (opcode == Opcode::kSchema) {
      Schema schema = read_schema(ByteReader(content));
      schemas_[schema.id] = std::move(schema);
    } else if (opcode == Opcode::kChannel) {
      Channel channel = read_channel(ByteReader(content));
      channels_[channel.id] = std::move(channel);
    } else if (opcode == Opcode::kMessage) {
      message = read_message(ByteReader(content));
      if (channels_.contains(message.channel_id)) {
        return true;
      }
      end("a message names a channel that the file does not describe");
    }
  }
  return false;
}

bool Reader::end(const std::string& why) {
  ended_ = true;
  ending_ = why;
  return false;
}

bool Reader::read_magic() {
  std::array<std::uint8_t, kMagic.size()> magic{};
  file_.read(reinterpret_cast<char*>(magic.data()), magic.size());
  left_ -= std::min<std::uint64_t>(left_, magic.size());
  return static_cast<bool>(file_) && magic == kMagic;
}

bool Reader::read_record(Opcode& opcode, std::vector<std::uint8_t>& content) {
  std::array<std::uint8_t, kRecordHead> head{};
  if (left_ < kRecordHead || !file_.read(reinterpret_cast<char*>(head.data()), head.size())) {
    return end(kCutOff);
  }
  left_ -= kRecordHead;
  ByteReader in(head);
  opcode = static_cast<Opcode>(in.number<std::uint8_t>());
  const auto length = in.number<std::uint64_t>();
  if (length > left_) {
    return end(kCutOff);
  }
  content.resize(static_cast<std::size_t>(length));
  if (!file_.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(length))) {
    return end("cannot read " + path_ + ": " + std::strerror(errno));
  }
  left_ -= length;
  return true;
}

bool Reader::read_next_chunk() {
  Opcode opcode{};
  while (read_record(opcode, record_)) {
    const std::uint64_t length = record_.size();
    switch (opcode) {
      case Opcode::kChunk:
        return read_chunk(record_);
      case Opcode::kMetadata:
        metadata_.push_back(read_metadata(ByteReader(record_)));
        break;
      case Opcode::kSchema:
      case Opcode::kChannel:
      case Opcode::kMessage:  // of a recorder that makes no chunks
        chunk_.assign(1, static_cast<std::uint8_t>(opcode));
        chunk_.resize(kRecordHead);
        std::memcpy(chunk_.data() + 1, &length, sizeof length);
        chunk_.insert(chunk_.end(), record_.begin(), record_.end());
        at_ = 0;
        return true;
      case Opcode::kDataEnd:
        file_.seekg(-static_cast<std::streamoff>(kMagic.size()), std::ios::end);
        return end(read_magic() ? "" : "the file was cut off behind its last message");
      default:
        break;  // indexes, attachments, and what later versions of the format bring
    }
  }
  return false;
}

bool Reader::read_chunk(std::span<const std::uint8_t> content) {
  ByteReader in(content);
  in.number<std::uint64_t>();  // times of its messages
  in.number<std::uint64_t>();
  const auto size = in.number<std::uint64_t>();
  const auto crc = in.number<std::uint32_t>();
  const std::string compression = in.text();
  const std::span<const std::uint8_t> compressed = in.bytes(in.number<std::uint64_t>());
  if (!in.good()) {
    return end("chunk " + std::to_string(chunks_) + " is damaged");
  }
  auto records = decompress(compressed, compression, size);
  if (!records) {
    return end(records.error().message);
  }
  if (crc != 0 && crc32(records.value()) != crc) {
    return end("chunk " + std::to_string(chunks_) + " is damaged: its CRC is not that of its bytes");
  }
  chunk_ = std::move(records).value();
  at_ = 0;
  ++chunks_;
  return true;
}

}  // namespace farrier::mcap
