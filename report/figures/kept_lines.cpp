#include "report/figures/kept_lines.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

namespace farrier::report {
namespace {

/// True if the file's last line lacks its end, as after a run that was killed.
bool ends_within_a_line(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  return file && file.tellg() > 0 && file.seekg(-1, std::ios::end) && file.get() != '\n';
}

}  // namespace

Result<Done> append_kept(const std::string& path, const nlohmann::json& origin, nlohmann::json line) {
  line["origin"] = origin;
  const bool cut_off = ends_within_a_line(path);
  std::ofstream file(path, std::ios::app);
  file << (cut_off ? "\n" : "") << line.dump() << '\n';
  file.flush();
  if (!file) {
    return Error{"cannot write " + path + ": " + std::strerror(errno)};
  }
  return Done{};
}

std::vector<nlohmann::json> read_kept(const std::string& path, const nlohmann::json& origin) {
  std::vector<nlohmann::json> lines;
  std::ifstream file(path);
  for (std::string text; std::getline(file, text);) {
    nlohmann::json line = nlohmann::json::parse(text, nullptr, false);
    if (line.is_object() && line.value("origin", nlohmann::json()) == origin) {
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

}  // namespace farrier::report
