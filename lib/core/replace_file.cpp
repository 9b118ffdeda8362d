#include "core/replace_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace farrier {

Result<Done> replace_file(const std::string& path, const std::string& text) {
  const std::string part = path + ".part";
  {
    std::ofstream file(part, std::ios::binary);
    file << text << std::flush;
    if (!file) {
      const Error refused{"cannot write " + part + ": " + std::strerror(errno)};
      std::remove(part.c_str());
      return refused;
    }
  }
  if (std::rename(part.c_str(), path.c_str()) != 0) {
    const Error refused{"cannot write " + path + ": " + std::strerror(errno)};
    std::remove(part.c_str());
    return refused;
  }
  return Done{};
}

}  // namespace farrier
