// Pages of docs/how-to name files that exist, and a model task touches few of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>

#include "documents.hpp"

namespace farrier::docs {
namespace touched_files_test {

namespace fs = std::filesystem;

/// A page and the largest number of files that its task may touch. Files that the program writes and
/// CHANGELOG.md, which every change touches, do not count.
struct Task {
  const char* page;
  std::size_t bound;
};
constexpr Task kTasks[] = {{"docs/how-to/new-sensor-channel.md", 8},
                           {"docs/how-to/new-fault.md", 3},
                           {"docs/how-to/new-estimator.md", 6},
                           {"docs/how-to/new-effect.md", 5},
                           {"docs/how-to/new-process.md", 5}};

/// Files of the first table of a page whose head is "| file | change |": the first code span of each row.
std::vector<std::string> touched_files(const Document& page) {
  static const std::regex kHead(R"re(\|\s*file\s*\|\s*change\s*\|\s*)re");
  std::vector<std::string> files;
  auto line = std::ranges::find_if(page.prose, [](const Line& l) { return std::regex_match(l.text, kHead); });
  for (line = line == page.prose.end() ? line : line + 2; line != page.prose.end() && line->text.starts_with("|");
       ++line) {
    const std::vector<std::string> spans = code_spans(line->text.substr(0, line->text.find('|', 1)));
    files.push_back(spans.empty() ? "" : spans.front());
  }
  return files;
}

/// True for a path from the repository's root that stands for one file: "lib/core/fault.hpp", not "lib/<name>.hpp".
bool is_path(const std::string& span) {
  static const std::regex kPath(R"re([a-z_][\w.-]*(/[\w.-]+)*/[\w.-]+\.[a-z]+)re");
  const std::string folder = span.substr(0, span.find('/'));
  return std::regex_match(span, kPath) && fs::is_directory(fs::path(FARRIER_SOURCE_DIR) / folder) && folder != "out" &&
         folder != "build";
}

bool exists(const std::string& path) { return fs::exists(fs::path(FARRIER_SOURCE_DIR) / path); }

TEST(TouchedFiles, OfEachTaskAreNoMoreThanItsBound) {
  for (const Task& task : kTasks) {
    const auto page = std::ranges::find(documents(), task.page, &Document::path);
    ASSERT_NE(page, documents().end()) << task.page;
    const std::vector<std::string> files = touched_files(*page);
    EXPECT_FALSE(files.empty()) << task.page << " has no table with the head | file | change |";
    EXPECT_LE(files.size(), task.bound) << task.page;
    for (const std::string& file : files) {
      const bool is_new = file.find('<') != std::string::npos;
      EXPECT_TRUE(is_new || exists(file)) << task.page << ": there is no " << file;
    }
  }
}

TEST(TouchedFiles, NamedInAHowToPageExist) {
  int checked = 0;
  for (const Document& document : documents()) {
    if (!document.path.starts_with("docs/how-to/")) {
      continue;
    }
    for (const Line& line : document.prose) {
      for (const std::string& span : code_spans(line.text)) {
        if (is_path(span)) {
          ++checked;
          EXPECT_TRUE(exists(span)) << at(document, line) << ": there is no " << span;
        }
      }
    }
  }
  EXPECT_GT(checked, 10) << "the test must find the files";
}

TEST(TouchedFiles, AreReadFromTheFirstTableOfTheForm) {
  const Document page{"a.md",
                      {{1, "| hook | use |"},
                       {2, "|---|---|"},
                       {3, "| `x` | y |"},
                       {4, "| file | change |"},
                       {5, "|---|---|"},
                       {6, "| [`lib/a.hpp`](../a.hpp) | `b` |"},
                       {7, "| `lib/<name>.hpp` | new |"},
                       {8, ""},
                       {9, "| file | change |"}},
                      {}};
  EXPECT_EQ(touched_files(page), (std::vector<std::string>{"lib/a.hpp", "lib/<name>.hpp"}));
  EXPECT_TRUE(is_path("lib/core/fault.hpp"));
  EXPECT_FALSE(is_path("lib/<name>.hpp"));
  EXPECT_FALSE(is_path("joint/sensors"));
}

}  // namespace touched_files_test
}  // namespace farrier::docs
