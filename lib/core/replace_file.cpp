#include "core/replace_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace farrier {

std::string part_path(const std::string& path) { return path + ".part"; }

Result<Done> name_part(const std::string& path) {
  if (std::rename(part_path(path).c_str(), path.c_str()) != 0) {
    return Error{"cannot write " + path + ": " + std::strerror(errno)};
  }
  return Done{};
}

Result<Done> replace_file(const std::string& path, const std::string& text) {
  const std::string part = part_path(path);
  {
    std::ofstream file(part, std::ios::binary);
    file << text << std::flush;
    if (!file) {
      const Error refused{"cannot write " + part + ": " + std::strerror(errno)};
      std::remove(part.c_str());
      return refused;
    }
  }
  auto named = name_part(path);
  if (!named) {
    std::remove(part.c_str());
  }
  return named;
}

}  // namespace farrier
