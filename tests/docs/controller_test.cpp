// The controller of docs/how-to/write-a-controller.md builds against an installation, and documents show it as it is.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "documents.hpp"
#include "tests/support/scratch_directory.hpp"

namespace farrier::docs {
namespace controller_test {

namespace fs = std::filesystem;

const fs::path kExample = fs::path(FARRIER_SOURCE_DIR) / "docs/how-to/controller";
constexpr const char* kReadMe = "README.md";
constexpr const char* kHowTo = "docs/how-to/write-a-controller.md";

std::string text_of(const Block& block) {
  std::string text;
  for (const Line& line : block.lines) {
    text += line.text + "\n";
  }
  return text;
}

/// True if the document has a fenced block with exactly this text.
bool shows(const std::string& path, const std::string& text) {
  const auto document = std::ranges::find(documents(), path, &Document::path);
  return document != documents().end() &&
         std::ranges::any_of(document->blocks, [&](const Block& block) { return text_of(block) == text; });
}

TEST(Controller, IsShownByTheDocumentsAsItIs) {
  for (const char* file : {"controller.cpp", "CMakeLists.txt"}) {
    const std::string text = content_of(kExample / file);
    ASSERT_FALSE(text.empty()) << file;
    for (const char* document : {kReadMe, kHowTo}) {
      EXPECT_TRUE(shows(document, text)) << document << " shows another " << file;
    }
  }
}

// As a user would: install, configure, build, run. The installed copy of the example is built, not that of the sources.
TEST(Controller, BuildsAgainstAnInstallationAndPrintsWhatTheDocumentsShow) {
  const test::ScratchDirectory scratch;
  const std::string prefix = scratch.file("prefix");
  const std::string build = scratch.file("build");
  const Ran installed = run("cmake --install '" FARRIER_BUILD_DIR "' --component dev --prefix '" + prefix + "'");
  ASSERT_EQ(installed.status, 0) << installed.output;
  const Ran built = run("cmake -S '" + prefix + "/share/doc/farrier-dev/controller' -B '" + build +
                        "' -DCMAKE_PREFIX_PATH='" + prefix + "' && cmake --build '" + build + "'");
  ASSERT_EQ(built.status, 0) << built.output;

  const Ran ran = run("'" + build + "/controller' '" FARRIER_SOURCE_DIR "/deploy/robots/hyq.yaml'");
  EXPECT_EQ(ran.status, 0);
  for (const char* document : {kReadMe, kHowTo}) {
    EXPECT_TRUE(shows(document, ran.output)) << document << " shows another output than\n" << ran.output;
  }
  const Ran refused = run("'" + build + "/controller' /nowhere/hyq.yaml");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.output.find("/nowhere/hyq.yaml"), std::string::npos) << refused.output;
}

}  // namespace controller_test
}  // namespace farrier::docs
