// Rules of style that a search can check.

#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "tests/architecture/target_graph.hpp"

namespace farrier::architecture {
namespace {

bool in_core(const Source& source) {
  const Target* owner = TargetGraph::of_product().owner(source.path);
  return owner != nullptr && owner->name.ends_with("_core") && owner->name != "farrier_core";
}

// Time and randomness are arguments.
TEST(Rules, NoLibraryAndNoProcessCoreReadsAClockOrDrawsARandomNumber) {
  static const std::regex clock(
      R"re((steady_clock|system_clock|high_resolution_clock)::now|\b(rand|srand|time|clock_gettime|gettimeofday)\s*\(|\brandom_device\b)re");
  Exceptions exceptions(kClocks);
  for (const Source& source : source_tree()) {
    if (!source.is_cpp() || source.in("tests") || !(source.in("lib") || in_core(source))) {
      continue;
    }
    const auto code = code_of(source);
    for (std::size_t i = 0; i < code.size(); ++i) {
      EXPECT_TRUE(!std::regex_search(code[i], clock) || exceptions.cover(source.path))
          << at(source, static_cast<int>(i) + 1) << ": " << source.lines[i];
    }
  }
  EXPECT_EQ(exceptions.unused(), "");
}

TEST(Rules, MainProgramsAreThin) {
  constexpr std::size_t kMostLines = 80;
  Exceptions exceptions(kLongMains);
  int mains = 0;
  for (const Source& source : source_tree()) {
    if (source.path.ends_with("/main.cpp")) {
      ++mains;
      EXPECT_TRUE(source.lines.size() <= kMostLines || exceptions.cover(source.path))
          << source.path << " has " << source.lines.size() << " lines";
    }
  }
  EXPECT_GE(mains, 5);
  EXPECT_EQ(exceptions.unused(), "");
}

TEST(Rules, FilesAreShort) {
  constexpr std::size_t kMostLines = 300;
  Exceptions exceptions(kLongFiles);
  for (const Source& source : source_tree()) {
    EXPECT_TRUE(source.lines.size() <= kMostLines || exceptions.cover(source.path))
        << source.path << " has " << source.lines.size() << " lines";
  }
  EXPECT_EQ(exceptions.unused(), "");
}

// A reader finds nothing in a flat folder of more files.
TEST(Rules, FoldersAreRooms) {
  constexpr std::size_t kMostFiles = 40;
  std::map<std::string, std::size_t> files;
  for (const Source& source : source_tree()) {
    if (source.is_cpp()) {
      ++files[source.path.substr(0, source.path.rfind('/'))];
    }
  }
  for (const auto& [folder, count] : files) {
    EXPECT_LE(count, kMostFiles) << folder;
  }
}

TEST(Rules, HeadersAreIncludedOnce) {
  for (const Source& source : source_tree()) {
    if (source.path.ends_with(".hpp")) {
      EXPECT_FALSE(source.lines.empty() || source.lines.front() != "#pragma once") << source.path;
    }
  }
}

TEST(Rules, NoHeaderOpensANamespaceForOthers) {
  static const std::regex using_namespace(R"re(^using namespace)re");
  for (const Source& source : source_tree()) {
    if (!source.path.ends_with(".hpp") || source.in("tests")) {
      continue;
    }
    for (const std::string& line : code_of(source)) {
      EXPECT_FALSE(std::regex_search(line, using_namespace)) << source.path << ": " << line;
    }
  }
}

}  // namespace
}  // namespace farrier::architecture
