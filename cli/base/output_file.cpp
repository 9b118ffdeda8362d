#include "cli/base/output_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace farrier::cli {

namespace fs = std::filesystem;

Result<OutputDirectory> OutputDirectory::claim(const std::string& path) {
  std::error_code refused;
  fs::create_directories(path, refused);
  if (refused) {
    return Error{"--out " + path + ": " + refused.message()};
  }
  OutputDirectory directory(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.file_ < 0) {
    return Error{"--out " + path + ": " + std::strerror(errno)};
  }
  // A file system without locks gives no exclusiveness, and no reason to refuse.
  if (::flock(directory.file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    return Error{"--out " + path + ": another run writes there: wait for it or give another directory"};
  }
  return directory;
}

OutputDirectory::OutputDirectory(OutputDirectory&& other) noexcept : file_(other.file_) { other.file_ = -1; }

OutputDirectory::~OutputDirectory() {
  if (file_ >= 0) {
    ::close(file_);
  }
}

Result<Done> make_way(const std::string& path) {
  std::error_code unknown;
  const fs::file_type type = fs::symlink_status(path, unknown).type();
  if (type != fs::file_type::not_found && type != fs::file_type::regular && type != fs::file_type::directory) {
    return Error{"cannot write " + path + ": it is not a regular file"};
  }
  errno = 0;
  if (!std::ofstream(path, std::ios::app)) {
    return Error{"cannot write " + path + ": " + std::strerror(errno)};
  }
  fs::remove(path, unknown);
  return Done{};
}

Result<Done> make_way(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  for (const std::string& output : outputs) {
    for (const std::string& input : inputs) {
      std::error_code unknown;
      if (!output.empty() && fs::equivalent(output, input, unknown)) {
        return Error{output + " is what is read: give another --out or --json"};
      }
    }
  }
  for (const std::string& output : outputs) {
    if (auto free = output.empty() ? Result<Done>(Done{}) : make_way(output); !free) {
      return free;
    }
  }
  return Done{};
}

}  // namespace farrier::cli
