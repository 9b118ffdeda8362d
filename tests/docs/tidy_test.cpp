// C++ that a change touches passes the checks of .clang-tidy.

#include <gtest/gtest.h>

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

TEST(Tidy, SourcesThatTheChangeTouchesPassTheChecks) {
  if (run("command -v clang-tidy").status != 0) {
    GTEST_SKIP() << "no clang-tidy here: apt install clang-tidy";
  }
  const std::string options = compiler_options();
  const fs::path scratch = fs::path(testing::TempDir()) / "tidy";
  fs::create_directories(scratch);
  for (const auto& [folder, sources] : changed_sources()) {
    const fs::path together = scratch / "together.cxx";
    std::ofstream text(together);
    for (const std::string& source : sources) {
      text << "#include \"" FARRIER_SOURCE_DIR "/" << source << "\"\n";
    }
    text.close();
    const Ran ran = run("cd '" FARRIER_SOURCE_DIR "' && clang-tidy --quiet --config-file=.clang-tidy '" +
                        together.string() + "' -- -std=c++20 -w" + options);
    EXPECT_EQ(ran.status, 0) << folder << "\n" << ran.output.substr(0, 3000);
  }
  fs::remove_all(scratch);
}

}  // namespace tidy_test
}  // namespace farrier::docs
