// C++ that a change touches passes the checks of .clang-tidy.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <nlohmann/json.hpp>
#include <set>

#include "documents.hpp"

namespace farrier::docs {
namespace tidy_test {

namespace fs = std::filesystem;

/// Include paths and definitions of every compilation of this build. Sources are compiled several at once, so that a
/// source has no command of its own.
std::string compiler_options() {
  static const std::regex kOption(R"re((-isystem \S+|-[ID]\S+))re");
  std::ifstream file(FARRIER_BUILD_DIR "/compile_commands.json");
  std::set<std::string> options;
  for (const nlohmann::json& compilation : nlohmann::json::parse(file)) {
    const std::string command = compilation.at("command");
    for (std::sregex_iterator match(command.begin(), command.end(), kOption), end; match != end; ++match) {
      options.insert(match->str());
    }
  }
  std::string all;
  for (const std::string& option : options) {
    all += ' ' + option;
  }
  return all;
}

/// The changed sources by folder: clang-tidy reads those of a folder as one, which parses their headers once. A source
/// with a main function stands alone.
std::map<std::string, std::vector<std::string>> changed_sources() {
  std::map<std::string, std::vector<std::string>> by_folder;
  for (const std::string& path : changed_files()) {
    const fs::path source(path);
    if (source.extension() == ".cpp") {
      by_folder[source.filename() == "main.cpp" ? path : source.parent_path().string()].push_back(path);
    }
  }
  return by_folder;
}

class Tidy : public testing::Test {
 protected:
  void SetUp() override {
    if (run("command -v clang-tidy").status != 0) {
      GTEST_SKIP() << "no clang-tidy here: apt install clang-tidy";
    }
    fs::create_directories(scratch_);
  }
  void TearDown() override { fs::remove_all(scratch_); }

  /// The findings of the checks in a source with this text, a line each. Errors of clang itself do not count: GCC
  /// compiles these sources, and clang 14 cannot read all of the ranges of GCC's library.
  std::vector<std::string> findings_in(const std::string& text) const {
    static const std::regex kFinding(R"re([^\n]*: error: [^\n]*\[(?!clang-diagnostic)[a-z][^\n\] ]*\])re");
    const fs::path source = scratch_ / "source.cxx";
    std::ofstream(source) << text;
    const std::string output = run("cd '" FARRIER_SOURCE_DIR "' && clang-tidy --quiet --config-file=.clang-tidy '" +
                                   source.string() + "' -- -std=c++20 -w" + compiler_options())
                                   .output;
    return {std::sregex_token_iterator(output.begin(), output.end(), kFinding), {}};
  }

  const fs::path scratch_ = fs::path(testing::TempDir()) / "tidy";
};

TEST_F(Tidy, FindsAUseAfterAMove) {
  EXPECT_EQ(findings_in("#include <utility>\n#include \"core/text.hpp\"\n"
                        "std::string f(std::string a) { std::string b = std::move(a); return a + b; }\n")
                .size(),
            1u);
}

/// A folder takes about ten seconds. A change of more folders than these is checked in parts, or by --all.
constexpr std::size_t kMostFolders = 6;

TEST_F(Tidy, SourcesThatTheChangeTouchesPassTheChecks) {
  const bool all = std::getenv("FARRIER_TIDY_ALL") != nullptr;
  std::size_t checked = 0;
  for (const auto& [folder, sources] : changed_sources()) {
    if (!all && ++checked > kMostFolders) {
      std::printf("not checked: %s; ctest -L long -R tidy checks every folder\n", folder.c_str());
      continue;
    }
    std::string together;
    for (const std::string& source : sources) {
      together += "#include \"" FARRIER_SOURCE_DIR "/" + source + "\"\n";
    }
    for (const std::string& finding : findings_in(together)) {
      ADD_FAILURE() << finding;
    }
  }
}

}  // namespace tidy_test
}  // namespace farrier::docs
