#include "tools/cli/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace farrier::cli {

namespace fs = std::filesystem;

Result<Done> make_way(const std::string& path) {
  std::error_code unknown;
  const fs::file_type type = fs::symlink_status(path, unknown).type();
  if (type != fs::file_type::not_found && type != fs::file_type::regular && type != fs::file_type::directory) {
    return Done{};
  }
  errno = 0;
  if (!std::ofstream(path, std::ios::app)) {
    return Error{"cannot write " + path + ": " + std::strerror(errno)};
  }
  fs::remove(path, unknown);
  return Done{};
}

}  // namespace farrier::cli
