#include "report/figures/kept_lines.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

namespace farrier::report {
namespace {

using nlohmann::json;

/// True if the file's last line lacks its end, as after a run that was killed.
bool ends_within_a_line(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  return file && file.tellg() > 0 && file.seekg(-1, std::ios::end) && file.get() != '\n';
}

}  // namespace

Result<Done> append_kept(const std::string& path, const json& origin, json line) {
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

std::vector<json> read_kept(const std::string& path, const json& origin) {
  std::vector<json> lines;
  std::ifstream file(path);
  for (std::string text; std::getline(file, text);) {
    json line = json::parse(text, nullptr, false);
    if (line.is_object() && line.value("origin", json()) == origin) {
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

}  // namespace farrier::report
