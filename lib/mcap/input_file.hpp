#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "core/result.hpp"

namespace farrier::mcap {

/// A regular file, read from its beginning through a buffer. Bytes that are skipped are not read.
class InputFile {
 public:
  /// Refuses a path that cannot be read, and what is no regular file.
  static Result<InputFile> open(const std::string& path);
  ~InputFile();
  InputFile(InputFile&& other) noexcept;
  InputFile& operator=(InputFile&&) = delete;

  /// Fills `to`. Returns false when the file ends before or cannot be read: see `failure`.
  bool read(std::span<std::uint8_t> to);
  /// Leaves bytes out, at most `left` of them.
  void skip(std::uint64_t count) noexcept;
  /// Goes to a place, at most the end of the file.
  void seek(std::uint64_t place) noexcept;

  /// Bytes of the file when it was opened.
  std::uint64_t size() const noexcept { return size_; }
  std::uint64_t left() const noexcept { return size_ - place_; }
  /// Reason why the system refuses to read; empty without one.
  const std::string& failure() const noexcept { return failure_; }

 private:
  InputFile(int file, std::string path, std::uint64_t size);
  std::size_t read_at_place(std::span<std::uint8_t> to);

  int file_;
  std::string path_;
  std::uint64_t size_;
  std::uint64_t place_ = 0;  // of the next byte
  std::unique_ptr<std::uint8_t[]> buffer_;
  std::uint64_t buffer_begin_ = 0;  // place of its first byte
  std::size_t buffered_ = 0;
  std::string failure_;
};

}  // namespace farrier::mcap
