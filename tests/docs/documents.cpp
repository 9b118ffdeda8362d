#include "documents.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

namespace farrier::docs {
namespace {

namespace fs = std::filesystem;

Document read(const fs::path& root, const fs::path& path) {
  Document document{path.lexically_relative(root).generic_string(), {}, {}};
  std::ifstream file(path);
  bool fenced = false;
  int number = 0;
  for (std::string text; std::getline(file, text);) {
    ++number;
    const std::size_t begin = text.find_first_not_of(' ');
    if (begin != std::string::npos && text.compare(begin, 3, "```") == 0) {
      fenced = !fenced;
      if (fenced) {
        document.blocks.push_back({text.substr(begin + 3), {}});
      }
    } else if (fenced) {
      document.blocks.back().lines.push_back({number, text});
    } else {
      document.prose.push_back({number, text});
    }
  }
  return document;
}

bool is_made(const std::string& folder) {
  return folder == "build" || folder == "out" || folder == "node_modules" || folder.starts_with(".");
}

std::vector<Document> read_all() {
  const fs::path root(FARRIER_SOURCE_DIR);
  std::vector<Document> found;
  for (fs::recursive_directory_iterator entry(root), end; entry != end; ++entry) {
    if (entry->is_directory() && is_made(entry->path().filename())) {
      entry.disable_recursion_pending();
    } else if (entry->path().extension() == ".md") {
      found.push_back(read(root, entry->path()));
    }
  }
  std::ranges::sort(found, {}, &Document::path);
  return found;
}

std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
  return {std::sregex_token_iterator(text.begin(), text.end(), pattern, 1), {}};
}

}  // namespace

const std::vector<Document>& documents() {
  static const std::vector<Document> all = read_all();
  return all;
}

std::string at(const Document& document, const Line& line) { return document.path + ":" + std::to_string(line.number); }

std::vector<std::string> code_spans(const std::string& text) {
  static const std::regex span("`([^`]+)`");
  return matches(text, span);
}

std::vector<std::string> links(const std::string& text) {
  static const std::regex span("`[^`]*`");
  static const std::regex link(R"re(\]\(([^()\s]+)\))re");
  return matches(std::regex_replace(text, span, ""), link);
}

std::set<std::string> anchors(const Document& document) {
  static const std::regex heading(R"re(^#{1,6}\s+(.*\S)\s*$)re");
  static const std::regex link(R"re(\[([^\]]*)\]\([^)]*\))re");
  std::set<std::string> names;
  std::map<std::string, int> seen;
  for (const Line& line : document.prose) {
    std::smatch match;
    if (!std::regex_match(line.text, match, heading)) {
      continue;
    }
    std::string name;
    bool plain = true;
    for (const char letter : std::regex_replace(match[1].str(), link, "$1")) {
      const auto c = static_cast<unsigned char>(letter);
      plain = plain && c < 0x80;
      if (std::isalnum(c) || c == '-' || c == '_') {
        name += static_cast<char>(std::tolower(c));
      } else if (c == ' ') {
        name += '-';
      }
    }
    if (const int before = seen[name]++; plain) {
      names.insert(before == 0 ? name : name + "-" + std::to_string(before));
    }
  }
  return names;
}

std::string content_of(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Ran run(const std::string& command_line) {
  Ran ran{-1, ""};
  std::FILE* const pipe = ::popen(("{ " + command_line + "\n} 2>&1").c_str(), "r");
  if (pipe == nullptr) {
    return ran;
  }
  std::array<char, 4096> part{};
  for (std::size_t got = 0; (got = std::fread(part.data(), 1, part.size(), pipe)) > 0;) {
    ran.output.append(part.data(), got);
  }
  const int status = ::pclose(pipe);
  ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ran;
}

std::string git(const std::string& arguments) {
  const Ran ran = run("git -C '" FARRIER_SOURCE_DIR "' " + arguments + " 2>/dev/null");
  return ran.status == 0 ? ran.output.substr(0, ran.output.find_last_not_of('\n') + 1) : "";
}

std::string base_of_the_change() {
  const std::string head = git("rev-parse HEAD");
  const std::string left = git("merge-base HEAD origin/main");
  return left.empty() || left == head ? git("rev-parse HEAD~1") : left;
}

std::vector<std::string> changed_files() {
  std::vector<std::string> paths;
  std::istringstream lines(git("diff --name-only --diff-filter=AM " + base_of_the_change()));
  for (std::string path; std::getline(lines, path);) {
    paths.push_back(path);
  }
  return paths;
}

}  // namespace farrier::docs
