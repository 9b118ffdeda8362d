// The program of docs/how-to/write-a-locomotion-process.md builds against an installation and stands the robot up.

#include <gtest/gtest.h>

#include <filesystem>

#include "documents.hpp"
#include "tests/support/scratch_directory.hpp"
#include "trace/body_trace.hpp"

namespace farrier::docs {
namespace locomotion_test {

TEST(OwnLocomotion, TakesThePlaceOfTheShippedOneAndStandsTheRobotUp) {
  const test::ScratchDirectory scratch;
  const std::string prefix = scratch.file("prefix");
  const std::string build = scratch.file("build");
  const Ran installed = run("cmake --install '" FARRIER_BUILD_DIR "' --component dev --prefix '" + prefix + "'");
  ASSERT_EQ(installed.status, 0) << installed.output;
  const Ran built = run("cmake -S '" + prefix + "/share/doc/farrier-dev/locomotion' -B '" + build +
                        "' -DCMAKE_PREFIX_PATH='" + prefix + "' && cmake --build '" + build + "'");
  ASSERT_EQ(built.status, 0) << built.output;

  const std::string out = scratch.file("out");
  const Ran ran = run("'" FARRIER_COMMAND "' trot --world body --locomotion '" + build +
                      "/stand_up' --duration 5 --out '" + out + "'");
  const auto body = trace::read_body_trace(out + "/trace_body.csv", 4);
  ASSERT_TRUE(body) << ran.output;
  ASSERT_EQ(body.value().size(), 5000u);
  // Sinks a little under the weight, which its springs carry.
  EXPECT_NEAR(body.value().back().position_m[2], 0.56, 0.05);
  EXPECT_GT(body.value().back().attitude[0], 0.999);
}

}  // namespace locomotion_test
}  // namespace farrier::docs
