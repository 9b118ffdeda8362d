#include "tools/web/page_files.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

namespace farrier::web {
namespace {

namespace fs = std::filesystem;

std::string type_of(const fs::path& file) {
  constexpr std::pair<std::string_view, const char*> kTypes[] = {{".html", "text/html; charset=utf-8"},
                                                                 {".css", "text/css; charset=utf-8"},
                                                                 {".js", "text/javascript; charset=utf-8"},
                                                                 {".svg", "image/svg+xml"}};
  const std::string extension = file.extension().string();
  for (const auto& [ending, type] : kTypes) {
    if (extension == ending) {
      return type;
    }
  }
  return "text/plain; charset=utf-8";
}

}  // namespace

Result<PageFiles> read_page(const std::string& directory) {
  PageFiles files;
  std::error_code problem;
  for (fs::directory_iterator entry(directory, problem), end; !problem && entry != end; entry.increment(problem)) {
    if (entry->is_regular_file()) {
      std::ifstream in(entry->path(), std::ios::binary);
      files["/" + entry->path().filename().string()] = {type_of(entry->path()), {std::istreambuf_iterator<char>(in), {}}};
    }
  }
  const auto index = files.find("/index.html");
  if (index == files.end()) {
    return Error{"the page is not in " + directory};
  }
  if (!files.contains("/uPlot.esm.js")) {
    return Error{"the page in " + directory +
                 " has no charts: it was built where npm was missing or could not reach its registry"};
  }
  PageFile page = index->second;
  files["/"] = std::move(page);
  return files;
}

}  // namespace farrier::web
