// The traces of a robot on a ground do not depend on which of its variants the C library picks for the processor.

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/system/farrier_command.hpp"

namespace farrier::test {
namespace other_processor_test {

struct Traces {
  std::string joints;
  std::string body;
};

/// The traces of ten seconds in process, in an environment with these tunables of glibc.
Traces traces_with(const char* tunables) {
  const ScratchDirectory scratch;
  Surroundings surroundings;
  surroundings.prepare = [tunables] { ::setenv("GLIBC_TUNABLES", tunables, 1); };
  std::string output;
  run_farrier({"trot", "--world", "body", "--dds", "inproc", "--duration", "10", "--out", scratch.file("out")}, &output,
              surroundings);
  return {read_file(scratch.file("out/trace.csv")), read_file(scratch.file("out/trace_body.csv"))};
}

TEST(OtherProcessor, GivesTheSameTracesOfARobotOnAGround) {
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("fma")) {
    GTEST_SKIP() << "this processor has no FMA: the C library has the plain variants without the tunable too";
  }
#else
  GTEST_SKIP() << "the C library has variants by processor on x86-64 only";
#endif
  const Traces here = traces_with("");
  const Traces older = traces_with("glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-AVX");
  ASSERT_GT(here.joints.size(), 1'000'000u);
  ASSERT_GT(here.body.size(), 1'000'000u);
  EXPECT_TRUE(here.joints == older.joints);
  EXPECT_TRUE(here.body == older.body);
}

}  // namespace other_processor_test
}  // namespace farrier::test
