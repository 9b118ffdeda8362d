#include "mcap/reader.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "mcap/compression.hpp"
#include "mcap/record_bytes.hpp"

namespace farrier::mcap {
namespace {

constexpr std::uint64_t kRecordHead = sizeof(std::uint8_t) + sizeof(std::uint64_t);
constexpr std::uint64_t kMessageHead = 2 + 4 + 8 + 8;
constexpr std::uint64_t kLargestChunkHead = 1024;  // of it without its records
constexpr std::uint64_t kAskEveryRecords = 1000;

constexpr const char* kCutOff = "the file was cut off: it ends in the middle of a record";

std::string chunk_name(std::uint64_t number) { return "chunk " + std::to_string(number); }

}  // namespace

Result<Reader> Reader::open(const std::string& path) {
  Reader reader(FARRIER_TRY(InputFile::open(path)));
  if (!reader.read_magic() || !reader.begin_record() || reader.opcode_ != Opcode::kHeader ||
      !reader.read_content(std::min(reader.length_, kLargestRecord))) {
    return Error{path + ": not an MCAP file"};
  }
  ByteReader header(reader.record_);
  header.text();
  reader.library_ = header.text();
  return reader;
}

bool Reader::next(Message& message) {
  while (!ended_) {
    const bool chunk_over = at_ == chunk_.size();
    if (!keeps_on(chunk_over && opcode_ == Opcode::kChunk) || (chunk_over && !read_next_chunk())) {
      break;
    }
    if (chunk_over) {
      continue;
    }
    ByteReader in(std::span<const std::uint8_t>(chunk_).subspan(at_));
    const auto opcode = static_cast<Opcode>(in.number<std::uint8_t>());
    const std::span<const std::uint8_t> content = in.bytes(in.number<std::uint64_t>());
    if (!in.good()) {
      leave_out(chunk_name(chunks_) + " ends in the middle of a record");
      at_ = chunk_.size();
      continue;
    }
    at_ = chunk_.size() - in.rest().size();
    if (opcode != Opcode::kMessage) {
      take(opcode, content);
    } else if (content.size() < kMessageHead) {
      leave_out("a message of " + std::to_string(content.size()) + " bytes");
    } else {
      message = read_message(ByteReader(content));
      if (channels_.contains(message.channel_id)) {
        return true;
      }
      leave_out("a message names channel " + std::to_string(message.channel_id) + ", which the file does not describe");
    }
  }
  return false;
}

void Reader::take(Opcode opcode, std::span<const std::uint8_t> content) {
  if (opcode == Opcode::kSchema) {
    Schema schema = read_schema(ByteReader(content));
    kept_bytes_ += schema.data.size();
    if (kept_bytes_ > kMostKeptBytes) {
      kept_bytes_ -= schema.data.size();
      schema.data.clear();
    }
    Schema& place = schemas_[schema.id];
    kept_bytes_ -= place.data.size();
    place = std::move(schema);
  } else if (opcode == Opcode::kChannel) {
    std::optional<Channel> channel = read_channel(ByteReader(content));
    if (!channel) {
      leave_out("the description of a channel");
      return;
    }
    const auto [place, added] = channels_.try_emplace(channel->id, *channel);
    if (!added && place->second != *channel) {
      place->second = std::move(*channel);
      ++redefinitions_;
    }
  }
}

bool Reader::end(const std::string& why) {
  ended_ = true;
  ending_ = why;
  if (damage_.count > 0 && why != kInterrupted) {
    ending_ = std::to_string(damage_.count) + (damage_.count == 1 ? " part of the file is" : " parts of the file are") +
              " damaged and left out: " + (damage_.count == 1 ? "" : "first ") + damage_.first +
              (why.empty() ? "" : "; " + why);
  }
  return false;
}

bool Reader::leave_out(const std::string& what) {
  if (damage_.count++ == 0) {
    damage_.first = what;
  }
  return true;
}

bool Reader::keeps_on(bool now) {
  if (!keep_on_ || (!now && ++records_ < kAskEveryRecords)) {
    return true;
  }
  records_ = 0;
  const double share = 1.0 - static_cast<double>(file_.left()) / static_cast<double>(file_.size());
  return keep_on_(share) || end(kInterrupted);
}

bool Reader::read_magic() {
  std::array<std::uint8_t, kMagic.size()> magic{};
  return file_.read(magic) && magic == kMagic;
}

/// Reads the head of a record. Returns false, with an ending, if the file does not have all of the record.
bool Reader::begin_record() {
  std::array<std::uint8_t, kRecordHead> head{};
  if (file_.left() < kRecordHead) {
    return end(kCutOff);
  }
  if (!file_.read(head)) {
    return end(file_.failure().empty() ? kCutOff : file_.failure());
  }
  ByteReader in(head);
  opcode_ = static_cast<Opcode>(in.number<std::uint8_t>());
  length_ = in.number<std::uint64_t>();
  return length_ <= file_.left() || end(kCutOff);
}

/// Reads up to `count` bytes of the record's content.
bool Reader::read_content(std::uint64_t count) {
  record_.resize(static_cast<std::size_t>(std::min(count, length_)));
  if (!file_.read(record_)) {
    return end(file_.failure().empty() ? kCutOff : file_.failure());
  }
  length_ -= record_.size();
  return true;
}

/// Reads records until there is something in chunk_.
bool Reader::read_next_chunk() {
  file_.skip(length_);  // what is left of the record before
  length_ = 0;
  if (!begin_record()) {
    return false;
  }
  const bool large = length_ > kLargestRecord;
  switch (opcode_) {
    case Opcode::kChunk:
      return read_chunk();
    case Opcode::kMetadata:
      if (!large && kept_bytes_ + length_ <= kMostKeptBytes) {
        kept_bytes_ += length_;
        if (!read_content(length_)) {
          return false;
        }
        metadata_.push_back(read_metadata(ByteReader(record_)));
      }
      return true;
    case Opcode::kSchema:
    case Opcode::kChannel:
      if (large) {
        return leave_out("a schema or channel of " + std::to_string(length_) + " bytes");
      }
      [[fallthrough]];
    case Opcode::kMessage:  // of a recorder that makes no chunks
      if (!read_content(large ? kMessageHead : length_)) {
        return false;
      }
      hand_on_record();
      return true;
    case Opcode::kFooter:  // of a writer without DataEnd
    case Opcode::kDataEnd:
      file_.seek(file_.size() - kMagic.size());
      return end(read_magic() ? "" : "the file was cut off behind its last message");
    default:
      return true;  // indexes, attachments, and what later versions of the format bring
  }
}

/// Makes a chunk of record_.
void Reader::hand_on_record() {
  const std::uint64_t length = record_.size();
  chunk_.assign(1, static_cast<std::uint8_t>(opcode_));
  chunk_.resize(kRecordHead);
  std::memcpy(chunk_.data() + 1, &length, sizeof length);
  chunk_.insert(chunk_.end(), record_.begin(), record_.end());
  at_ = 0;
}

bool Reader::read_chunk() {
  const std::uint64_t number = ++chunks_;
  const std::uint64_t all = length_;
  if (!read_content(kLargestChunkHead)) {
    return false;
  }
  ByteReader in(record_);
  in.number<std::uint64_t>();  // times of its messages
  in.number<std::uint64_t>();
  const auto size = in.number<std::uint64_t>();
  const auto crc = in.number<std::uint32_t>();
  const std::string compression = in.text();
  const auto compressed = in.number<std::uint64_t>();
  const std::uint64_t head = record_.size() - in.rest().size();
  if (!in.good() || compressed > all - head) {
    return leave_out(chunk_name(number) + " is shorter than it says");
  }
  if (size == 0) {
    return true;  // nothing is in it
  }
  if (size > kLargestChunk || compressed > kLargestChunk) {
    return leave_out(chunk_name(number) + " has " + std::to_string(std::max(size, compressed)) + " bytes, more than " +
                     std::to_string(kLargestChunk) + ": write smaller chunks");
  }
  chunk_ = {};
  at_ = 0;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(static_cast<std::size_t>(compressed));
  bytes.assign(in.rest().begin(),
               in.rest().begin() + static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(compressed, in.rest().size())));
  while (bytes.size() < compressed) {
    const std::size_t before = bytes.size();
    bytes.resize(std::min(static_cast<std::size_t>(compressed), before + kPieceBytes));
    if (!file_.read(std::span(bytes).subspan(before))) {
      return end(file_.failure().empty() ? kCutOff : file_.failure());
    }
    length_ -= bytes.size() - before;
    if (bytes.size() < compressed && !keeps_on(true)) {
      return false;
    }
  }
  auto records = decompress(std::move(bytes), compression, size, [this] { return keeps_on(true); });
  if (ended_) {
    return false;
  }
  if (!records) {
    return leave_out(chunk_name(number) + ": " + records.error().message);
  }
  std::uint32_t sum = 0;
  for (std::span<const std::uint8_t> rest = records.value(); !rest.empty() && crc != 0;) {
    const auto piece = rest.first(std::min(rest.size(), kPieceBytes));
    sum = crc32(piece, sum);
    rest = rest.subspan(piece.size());
    if (!rest.empty() && !keeps_on(true)) {
      return false;
    }
  }
  if (sum != crc) {
    return leave_out(chunk_name(number) + ": its CRC is not that of its bytes");
  }
  chunk_ = std::move(records).value();
  return true;
}

}  // namespace farrier::mcap
