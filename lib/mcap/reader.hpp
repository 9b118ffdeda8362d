#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/keep_on.hpp"
#include "core/result.hpp"
#include "mcap/input_file.hpp"
#include "mcap/records.hpp"

namespace farrier::mcap {

/// The ending of a file whose reading was stopped.
inline constexpr const char* kInterrupted = "interrupted";

/// Chunks and records of a file that are left out because they are damaged.
struct Damage {
  std::uint64_t count = 0;
  std::string first;  ///< the first of them, and the reason
};

/// Reads an MCAP file from its beginning, one chunk in memory at a time, without its summary: a file that was cut off
/// is read up to its last whole chunk. Damaged chunks and records are left out and counted. Attachments, and metadata
/// and messages of more than kLargestRecord bytes, are not read.
class Reader {
 public:
  /// Records outside chunks whose content is not taken into memory, and the memory for metadata and schemas of a file.
  static constexpr std::uint64_t kLargestRecord = 1u << 24;
  static constexpr std::uint64_t kMostKeptBytes = 1u << 26;

  /// Refuses a file that cannot be read or is not MCAP.
  static Result<Reader> open(const std::string& path);

  /// `keep_on` is called at every chunk, and at every thousandth record. If it returns false the file ends,
  /// with kInterrupted.
  void ask(KeepOn keep_on) { keep_on_ = std::move(keep_on); }

  /// The next message, in the file's order; its data is valid until the next call. Empty data: the message is outside
  /// chunks and larger than kLargestRecord. False at the end: see `ending`.
  bool next(Message& message);

  /// Those read so far, by id.
  const std::map<std::uint16_t, Schema>& schemas() const noexcept { return schemas_; }
  const std::map<std::uint16_t, Channel>& channels() const noexcept { return channels_; }
  /// Rises when a channel of an id that was in use is defined otherwise.
  std::uint64_t redefinitions() const noexcept { return redefinitions_; }
  const std::vector<Metadata>& metadata() const noexcept { return metadata_; }
  const std::string& library() const noexcept { return library_; }
  std::uint64_t chunks() const noexcept { return chunks_; }

  /// Reason why there are no more messages. Empty: the writer ended the file and all of it was good.
  const std::string& ending() const noexcept { return ending_; }
  const Damage& damage() const noexcept { return damage_; }

 private:
  explicit Reader(InputFile file) : file_(std::move(file)) {}

  bool keeps_on(bool now);
  bool read_magic();
  bool begin_record();
  bool read_content(std::uint64_t count);
  bool read_next_chunk();
  bool read_chunk();
  void hand_on_record();
  void take(Opcode opcode, std::span<const std::uint8_t> content);
  bool end(const std::string& why);
  bool leave_out(const std::string& what);

  InputFile file_;
  KeepOn keep_on_;
  std::uint64_t records_ = 0;  // since keep_on_ was called
  Opcode opcode_{};            // of the record that begins where the file is read
  std::uint64_t length_ = 0;   // of its content, as far as that is not read
  std::string library_;
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
  std::vector<Metadata> metadata_;
  std::uint64_t redefinitions_ = 0;
  std::uint64_t kept_bytes_ = 0;
  std::uint64_t chunks_ = 0;
  std::vector<std::uint8_t> record_;
  std::vector<std::uint8_t> chunk_;
  std::size_t at_ = 0;  // in the chunk
  Damage damage_;
  std::string ending_;
  bool ended_ = false;
};

/// Searches a file for the first metadata record of this name, without reading its messages. Empty without one, in a
/// file that cannot be read, and when `keep_on` returns false.
std::optional<Metadata> find_metadata(const std::string& path, const std::string& name, const KeepOn& keep_on = {});

}  // namespace farrier::mcap
