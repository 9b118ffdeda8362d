#pragma once

#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "mcap/records.hpp"

namespace farrier::mcap {

/// Reads an MCAP file from its beginning, one chunk in memory at a time, without its summary: a file that was cut off
/// is read up to its last whole chunk.
class Reader {
 public:
  /// Refuses a file that cannot be read or is not MCAP.
  static Result<Reader> open(const std::string& path);

  /// The next message, in the file's order; its data is valid until the next call. False at the end: see `ending`.
  bool next(Message& message);

  /// Those read so far, by id.
  const std::map<std::uint16_t, Schema>& schemas() const noexcept { return schemas_; }
  const std::map<std::uint16_t, Channel>& channels() const noexcept { return channels_; }
  const std::vector<Metadata>& metadata() const noexcept { return metadata_; }
  const std::string& library() const noexcept { return library_; }
  std::uint64_t chunks() const noexcept { return chunks_; }
  /// Share of the file that was read, 0 to 1.
  double share_read() const noexcept { return 1.0 - static_cast<double>(left_) / static_cast<double>(size_); }

  /// Reason why there are no more messages. Empty: the writer ended the file and all of it was good.
  const std::string& ending() const noexcept { return ending_; }

 private:
  Reader(const std::string& path, std::uint64_t size)
      : file_(path, std::ios::binary), path_(path), size_(size), left_(size) {}

  bool read_magic();
  bool read_record(Opcode& opcode, std::vector<std::uint8_t>& content);
  bool read_chunk(std::span<const std::uint8_t> content);
  bool read_next_chunk();
  bool end(const std::string& why);

  std::ifstream file_;
  std::string path_;
  std::uint64_t size_;  // bytes of the file
  std::uint64_t left_;  // those not read yet
  std::string library_;
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
  std::vector<Metadata> metadata_;
  std::uint64_t chunks_ = 0;
  std::vector<std::uint8_t> record_;
  std::vector<std::uint8_t> chunk_;
  std::size_t at_ = 0;  // in the chunk
  std::string ending_;
  bool ended_ = false;
};

}  // namespace farrier::mcap
