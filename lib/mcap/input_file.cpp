#include "mcap/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace farrier::mcap {
namespace {

constexpr std::size_t kBufferBytes = 1u << 16;

Error unreadable(const std::string& path, const std::string& why) { return {"cannot read " + path + ": " + why}; }

}  // namespace

Result<InputFile> InputFile::open(const std::string& path) {
  // Without O_NONBLOCK a pipe that nobody writes would keep the command for ever.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) {
    return unreadable(path, std::strerror(errno));
  }
  struct stat facts {};
  if (::fstat(file, &facts) != 0 || !S_ISREG(facts.st_mode)) {
    const std::string why = S_ISDIR(facts.st_mode) ? std::strerror(EISDIR) : "it is not a regular file";
    ::close(file);
    return unreadable(path, why);
  }
  return InputFile(file, path, static_cast<std::uint64_t>(facts.st_size));
}

InputFile::InputFile(int file, std::string path, std::uint64_t size)
    : file_(file),
      path_(std::move(path)),
      size_(size),
      buffer_(std::make_unique_for_overwrite<std::uint8_t[]>(kBufferBytes)) {}

InputFile::~InputFile() {
  if (file_ >= 0) {
    ::close(file_);
  }
}

InputFile::InputFile(InputFile&& other) noexcept
    : file_(std::exchange(other.file_, -1)),
      path_(std::move(other.path_)),
      size_(other.size_),
      place_(other.place_),
      buffer_(std::move(other.buffer_)),
      buffer_begin_(other.buffer_begin_),
      buffered_(other.buffered_),
      failure_(std::move(other.failure_)) {}

void InputFile::skip(std::uint64_t count) noexcept { place_ += std::min(count, left()); }

void InputFile::seek(std::uint64_t place) noexcept { place_ = std::min(place, size_); }

bool InputFile::read(std::span<std::uint8_t> to) {
  while (!to.empty()) {
    if (place_ < buffer_begin_ || place_ >= buffer_begin_ + buffered_) {
      if (to.size() >= kBufferBytes) {
        const std::size_t count = read_at_place(to);
        place_ += count;
        to = to.subspan(count);
        if (count == 0) {
          return false;
        }
        continue;
      }
      buffer_begin_ = place_;
      buffered_ = read_at_place({buffer_.get(), kBufferBytes});
      if (buffered_ == 0) {
        return false;
      }
    }
    const std::uint8_t* from = buffer_.get() + (place_ - buffer_begin_);
    const std::size_t count = std::min<std::size_t>(to.size(), buffered_ - (place_ - buffer_begin_));
    std::memcpy(to.data(), from, count);
    place_ += count;
    to = to.subspan(count);
  }
  return true;
}

std::size_t InputFile::read_at_place(std::span<std::uint8_t> to) {
  ssize_t count = -1;
  do {
    count = ::pread(file_, to.data(), to.size(), static_cast<off_t>(place_));
  } while (count < 0 && errno == EINTR);
  if (count < 0) {
    failure_ = unreadable(path_, std::strerror(errno)).message;
  }
  return count < 0 ? 0 : static_cast<std::size_t>(count);
}

}  // namespace farrier::mcap
