#include "trace/line_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace farrier::trace {

std::string path_beside(const std::string& trace_path, const std::string& what) {
  const std::filesystem::path path(trace_path);
  return (path.parent_path() / (path.stem().string() + "_" + what + path.extension().string())).string();
}

Result<LineFile> LineFile::create(const std::string& path, const std::string& header) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr) {
    return Error{"cannot write the trace " + path + ": " + std::strerror(errno)};
  }
  std::fprintf(file, "%s\n", header.c_str());
  return LineFile(file);
}

void LineFile::write_lines(std::string_view lines) { std::fwrite(lines.data(), 1, lines.size(), file_.get()); }

bool LineFile::finish() { return std::fflush(file_.get()) == 0 && std::ferror(file_.get()) == 0; }

}  // namespace farrier::trace
