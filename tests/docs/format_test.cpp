// C++ that a change touches is formatted as .clang-format says.

#include <gtest/gtest.h>

#include "documents.hpp"

namespace farrier::docs {
namespace format_test {

TEST(Format, OfFilesThatTheChangeTouchesIsThatOfClangFormat) {
  if (run("command -v clang-format").status != 0) {
    GTEST_SKIP() << "no clang-format here: apt install clang-format";
  }
  if (git("show " + base_of_the_change() + ":.clang-format").empty()) {
    GTEST_SKIP() << "no history that has this rule";
  }
  for (const std::string& path : changed_files()) {
    if (path.ends_with(".cpp") || path.ends_with(".hpp")) {
      const Ran ran = run("cd '" FARRIER_SOURCE_DIR "' && clang-format --dry-run -Werror '" + path + "'");
      EXPECT_EQ(ran.status, 0) << "format it with: clang-format -i " << path << "\n" << ran.output.substr(0, 500);
    }
  }
}

}  // namespace format_test
}  // namespace farrier::docs
