#include "tests/architecture/source_tree.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace farrier::architecture {
namespace {

namespace fs = std::filesystem;

/// The first words in parentheses behind `command` in a CMake file.
std::vector<std::string> arguments_of(const Source& cmake, const std::string& command) {
  const std::regex call("^\\s*" + command + "\\(([^)]*)\\)");
  std::vector<std::string> found;
  for (const std::string& line : cmake.lines) {
    if (std::smatch match; std::regex_search(line, match, call)) {
      found.push_back(match[1]);
    }
  }
  return found;
}

bool is_source(const fs::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".cpp" || extension == ".hpp" || extension == ".def" || extension == ".cmake" ||
         extension == ".idl" || path.filename() == "CMakeLists.txt";
}

/// Names of the programs in core/processes.def, in its order.
std::vector<std::string> processes_of(const Source& list) {
  static const std::regex row(R"re(^FARRIER_PROCESS\(\w+, (\w+),)re");
  std::vector<std::string> names;
  for (const std::string& line : list.lines) {
    if (std::smatch match; std::regex_search(line, match, row)) {
      names.push_back(match[1]);
    }
  }
  return names;
}

Source read(const fs::path& root, const fs::path& path) {
  Source source{path.lexically_relative(root).generic_string(), {}};
  std::ifstream stream(path);
  for (std::string line; std::getline(stream, line);) {
    source.lines.push_back(line);
  }
  return source;
}

std::vector<Source> read_tree() {
  const fs::path root(FARRIER_SOURCE_DIR);
  std::vector<Source> tree{read(root, root / "CMakeLists.txt")};
  std::set<std::string> folders{"cmake", "idl"};
  for (const std::string& folder : arguments_of(tree.front(), "add_subdirectory")) {
    if (!folder.starts_with("$")) {
      folders.insert(folder.substr(0, folder.find('/')));
    }
  }
  for (const std::string& process : processes_of(read(root, root / "lib/core/processes.def"))) {
    folders.insert(process);
  }
  for (const std::string& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.is_regular_file() && is_source(entry.path())) {
        tree.push_back(read(root, entry.path()));
      }
    }
  }
  std::sort(tree.begin(), tree.end(), [](const Source& a, const Source& b) { return a.path < b.path; });
  return tree;
}

}  // namespace

const std::vector<Source>& source_tree() {
  static const std::vector<Source> tree = read_tree();
  return tree;
}

std::vector<std::string> processes() { return processes_of(*find_source("lib/core/processes.def")); }

const Source* find_source(const std::string& path) {
  const auto& tree = source_tree();
  const auto place = std::lower_bound(tree.begin(), tree.end(), path,
                                      [](const Source& s, const std::string& p) { return s.path < p; });
  return place != tree.end() && place->path == path ? &*place : nullptr;
}

std::vector<Include> includes_of(const Source& source) {
  static const std::regex pattern(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
  std::vector<Include> includes;
  for (std::size_t i = 0; i < source.lines.size(); ++i) {
    if (std::smatch match; std::regex_search(source.lines[i], match, pattern)) {
      includes.push_back({match[2], match[1] == "\"", static_cast<int>(i) + 1});
    }
  }
  return includes;
}

std::vector<std::string> code_of(const Source& source) {
  static const std::regex literal(R"re("(?:[^"\\]|\\.)*")re");
  std::vector<std::string> code;
  for (const std::string& line : source.lines) {
    std::string text = std::regex_replace(line, literal, "\"\"");
    text.resize(std::min(text.size(), text.find("//")));  // the product has no /* comments */
    code.push_back(std::move(text));
  }
  return code;
}

std::string at(const Source& source, int line) { return source.path + ":" + std::to_string(line); }

bool Exceptions::cover(const std::string& path) {
  bool covered = false;
  for (std::size_t i = 0; i < list_.size(); ++i) {
    const std::string excepted(list_[i].path);
    if (!excepted.empty() && (path == excepted || path.rfind(excepted + "/", 0) == 0)) {
      covered = used_[i] = true;
    }
  }
  return covered;
}

std::string Exceptions::unused() const {
  std::string text;
  for (std::size_t i = 0; i < list_.size(); ++i) {
    if (!used_[i] && !list_[i].path.empty()) {
      text += std::string(list_[i].path) + "\n";
    }
  }
  return text;
}

}  // namespace farrier::architecture
