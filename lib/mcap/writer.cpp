#include "mcap/writer.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/ensure.hpp"

namespace farrier::mcap {
namespace {

/// Offset and length of the records of one kind in the summary.
struct SummaryGroup {
  Opcode opcode;
  std::uint64_t offset;
  std::uint64_t length;
};

/// Opens a file for writing. It is empty, and no other Writer has it.
Result<std::FILE*> open_alone(const std::string& path) {
  constexpr mode_t kForAll = 0666;
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, kForAll);
  struct stat facts {};
  std::FILE* file = nullptr;
  if (descriptor >= 0 && ::fstat(descriptor, &facts) == 0) {
    // A file system without locks gives no exclusiveness, and no reason to refuse.
    if (S_ISREG(facts.st_mode) && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(descriptor);
      return Error{"another program writes " + path + ": wait for it or give another file"};
    }
    if (!S_ISREG(facts.st_mode) || ::ftruncate(descriptor, 0) == 0) {
      file = ::fdopen(descriptor, "wb");
    }
  }
  if (file == nullptr) {
    const Error refused{"cannot write " + path + ": " + std::strerror(errno)};
    if (descriptor >= 0) {
      ::close(descriptor);
    }
    return refused;
  }
  return file;
}

}  // namespace

Result<Writer> Writer::create(const std::string& path, const std::string& profile, const std::string& library,
                              std::size_t chunk_bytes) {
  std::FILE* const file = FARRIER_TRY(open_alone(path));
  Writer writer(file, path, chunk_bytes);
  writer.scratch_.bytes(kMagic);
  writer.scratch_.record(Opcode::kHeader, [&] {
    writer.scratch_.text(profile);
    writer.scratch_.text(library);
  });
  writer.put(writer.scratch_.view());
  return writer;
}

std::uint16_t Writer::add_schema(Schema schema) {
  schema.id = static_cast<std::uint16_t>(schemas_.size() + 1);
  gathering_.write(schema);
  schemas_.push_back(std::move(schema));
  return schemas_.back().id;
}

std::uint16_t Writer::add_channel(Channel channel) {
  channel.id = static_cast<std::uint16_t>(channels_.size());
  gathering_.write(channel);
  channels_.push_back(std::move(channel));
  return channels_.back().id;
}

void Writer::write(const Message& message) {
  gathering_.write(message);
  if (gathering_.size() >= chunk_bytes_) {
    flush();
  }
}

void Writer::write(const Chunk& chunk) {
  flush();
  put_chunk(chunk);
}

void Writer::write(const Metadata& metadata) {
  flush();
  scratch_.clear();
  append(scratch_, metadata);
  metadata_.push_back({offset_, scratch_.size(), metadata.name});
  put(scratch_.view());
}

void Writer::flush() {
  put_chunk(gathering_);
  gathering_.clear();
}

void Writer::flush_file() {
  if (!failed() && std::fflush(file_.get()) != 0) {
    failure_ = "cannot write " + path_ + ": " + std::strerror(errno);
  }
}

void Writer::put(std::span<const std::uint8_t> bytes) {
  if (failed()) {
    return;
  }
  data_crc_ = crc32(bytes, data_crc_);
  offset_ += bytes.size();
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) {
    failure_ = "cannot write " + path_ + ": " + std::strerror(errno);
  }
}

void Writer::put_chunk(const Chunk& chunk) {
  if (chunk.size() == 0) {
    return;
  }
  const std::span<const std::uint8_t> compressed = compressor_.compress(chunk.records());
  ChunkIndex index{.first_ns = chunk.first_ns(), .last_ns = chunk.last_ns(), .offset = offset_, .compression = "zstd"};
  index.compressed_size = compressed.size();
  index.uncompressed_size = chunk.size();
  scratch_.clear();
  scratch_.record(Opcode::kChunk, [&] {
    scratch_.number(index.first_ns);
    scratch_.number(index.last_ns);
    scratch_.number(index.uncompressed_size);
    scratch_.number(crc32(chunk.records()));
    scratch_.text(index.compression);
    scratch_.number(index.compressed_size);
    scratch_.bytes(compressed);
  });
  index.length = scratch_.size();
  put(scratch_.view());
  const std::uint64_t indexes_at = offset_;
  index.index_offsets = put_message_indexes(chunk);
  index.index_length = offset_ - indexes_at;
  chunks_.push_back(std::move(index));
  if (chunk.messages() > 0) {
    statistics_.first_ns =
        statistics_.messages == 0 ? chunk.first_ns() : std::min(statistics_.first_ns, chunk.first_ns());
    statistics_.last_ns = std::max(statistics_.last_ns, chunk.last_ns());
    statistics_.messages += chunk.messages();
  }
  flush_file();
}

std::map<std::uint16_t, std::uint64_t> Writer::put_message_indexes(const Chunk& chunk) {
  std::map<std::uint16_t, std::uint64_t> offsets;
  for (std::size_t channel = 0; channel < chunk.places().size(); ++channel) {
    const std::vector<MessagePlace>& places = chunk.places()[channel];
    if (places.empty()) {
      continue;
    }
    const auto id = static_cast<std::uint16_t>(channel);
    statistics_.messages_of[id] += places.size();
    scratch_.clear();
    scratch_.record(Opcode::kMessageIndex, [&] {
      scratch_.number(id);
      scratch_.prefixed([&] {
        scratch_.bytes({reinterpret_cast<const std::uint8_t*>(places.data()), places.size() * sizeof(MessagePlace)});
      });
    });
    offsets[id] = offset_;
    put(scratch_.view());
  }
  return offsets;
}

void Writer::put_summary() {
  const std::uint64_t start = offset_;
  data_crc_ = 0;  // of the summary from here on
  std::vector<SummaryGroup> groups;
  const auto group = [&](Opcode opcode, auto&& append_all) {
    scratch_.clear();
    append_all();
    if (scratch_.size() > 0) {
      groups.push_back({opcode, offset_, scratch_.size()});
      put(scratch_.view());
    }
  };
  const auto append_each = [&](const auto& records) {
    return [&] {
      for (const auto& record : records) {
        append(scratch_, record);
      }
    };
  };
  group(Opcode::kSchema, append_each(schemas_));
  group(Opcode::kChannel, append_each(channels_));
  group(Opcode::kStatistics, [&] { append(scratch_, statistics_); });
  group(Opcode::kChunkIndex, append_each(chunks_));
  group(Opcode::kMetadataIndex, [&] {
    for (const MetadataIndex& index : metadata_) {
      scratch_.record(Opcode::kMetadataIndex, [&] {
        scratch_.number(index.offset);
        scratch_.number(index.length);
        scratch_.text(index.name);
      });
    }
  });
  const std::uint64_t offsets_start = offset_;
  scratch_.clear();
  for (const SummaryGroup& one : groups) {
    scratch_.record(Opcode::kSummaryOffset, [&] {
      scratch_.number(static_cast<std::uint8_t>(one.opcode));
      scratch_.number(one.offset);
      scratch_.number(one.length);
    });
  }
  put(scratch_.view());
  // The summary's CRC covers the footer up to itself.
  scratch_.clear();
  scratch_.number(static_cast<std::uint8_t>(Opcode::kFooter));
  scratch_.number(std::uint64_t{2 * sizeof(std::uint64_t) + sizeof(std::uint32_t)});
  scratch_.number(start);
  scratch_.number(offsets_start);
  put(scratch_.view());
  scratch_.clear();
  scratch_.number(data_crc_);
  scratch_.bytes(kMagic);
  put(scratch_.view());
}

Result<Done> Writer::finish() {
  flush();
  statistics_.schemas = static_cast<std::uint16_t>(schemas_.size());
  statistics_.channels = static_cast<std::uint32_t>(channels_.size());
  statistics_.metadata = static_cast<std::uint32_t>(metadata_.size());
  statistics_.chunks = static_cast<std::uint32_t>(chunks_.size());
  const std::uint32_t crc = data_crc_;
  scratch_.clear();
  scratch_.record(Opcode::kDataEnd, [&] { scratch_.number(crc); });
  put(scratch_.view());
  put_summary();
  flush_file();
  if (failed()) {
    return Error{failure_};
  }
  return Done{};
}

}  // namespace farrier::mcap
