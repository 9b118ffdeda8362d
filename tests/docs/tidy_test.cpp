// C++ that a change touches passes the checks of .clang-tidy.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <nlohmann/json.hpp>
#include <set>

#include "documents.hpp"
#include "tests/support/scratch_directory.hpp"

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
  }

  /// The findings of the checks in a source with this text, a line each. Errors of clang itself do not count: GCC
  /// compiles these sources, and clang 14 cannot read all of the ranges of GCC's library.
  std::vector<std::string> findings_in(const std::string& text) const {
    static const std::regex kFinding(R"re([^\n]*: error: [^\n]*\[(?!clang-diagnostic)[a-z][^\n\] ]*\])re");
    const Ran ran = run("cd '" FARRIER_SOURCE_DIR "' && clang-tidy --quiet --config-file=.clang-tidy '" +
                        source_of(text) + "' -- -std=c++20 -w" + compiler_options());
    EXPECT_TRUE(ran.status == 0 || ran.status == 1) << "clang-tidy ended with status " << ran.status;
    return {std::sregex_token_iterator(ran.output.begin(), ran.output.end(), kFinding), {}};
  }

  /// A digest of all that findings_in(text) depends on: the contents of every file that the source includes, the checks,
  /// clang-tidy and its options. Empty where the compiler cannot read the source.
  std::string digest_of(const std::string& text) const {
    const std::string included = scratch_.file("included");
    const Ran ran = run("cd '" FARRIER_SOURCE_DIR "' && c++ -std=c++20 -w" + compiler_options() + " -x c++ -M '" +
                        source_of(text) + "' > '" + included + "' && { tr -s ' \\\\\\n' '\\n' < '" + included +
                        "' | grep / | xargs sha256sum .clang-tidy | cut -d ' ' -f 1; clang-tidy --version; echo '" +
                        compiler_options() + "'; } | sha256sum");
    const std::string words_behind = "  -\n";
    return ran.status == 0 && ran.output.ends_with(words_behind) ? ran.output : "";
  }

  test::ScratchDirectory scratch_;

 private:
  std::string source_of(const std::string& text) const {
    const std::string source = scratch_.file("source.cxx");
    std::ofstream(source) << text;
    return source;
  }
};

/// A file that holds the digest with which a folder's sources passed the checks. They are not checked again with it.
fs::path passed_with(std::string folder) {
  std::ranges::replace(folder, '/', '_');
  const fs::path passed = fs::path(FARRIER_BUILD_DIR) / "tidy_passed";
  fs::create_directories(passed);
  return passed / folder;
}

TEST_F(Tidy, FindsAUseAfterAMove) {
  EXPECT_EQ(findings_in("#include <utility>\n#include \"core/text.hpp\"\n"
                        "std::string f(std::string a) { std::string b = std::move(a); return a + b; }\n")
                .size(),
            1u);
}

TEST_F(Tidy, ChecksAgainWhenAnIncludedFileChanges) {
  const std::string text = "#include \"" + scratch_.file("header.hpp") + "\"\n";
  const auto digest_with = [&](const char* header) {
    std::ofstream(scratch_.file("header.hpp")) << header;
    return digest_of(text);
  };
  const std::string before = digest_with("int f();\n");
  ASSERT_NE(before, "");
  EXPECT_EQ(digest_with("int f();\n"), before);
  EXPECT_NE(digest_with("int f();  // NOLINT\n"), before);
  EXPECT_NE(digest_of(text + "int g();\n"), before);
  EXPECT_EQ(digest_of("#include \"no/such/header.hpp\"\n"), "") << "is checked each time";
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
    const fs::path memory = passed_with(folder);
    const std::string digest = digest_of(together);
    if (digest != "" && content_of(memory) == digest) {
      continue;
    }
    const std::vector<std::string> findings = findings_in(together);
    for (const std::string& finding : findings) {
      ADD_FAILURE() << finding;
    }
    if (!HasFailure()) {
      std::ofstream(memory) << digest;
    }
  }
}

}  // namespace tidy_test
}  // namespace farrier::docs
