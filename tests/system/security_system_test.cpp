// farrier security and --security as a user meets them: keys, a trot with them, and what is refused.

#include <gtest/gtest.h>

#include "farrier_command.hpp"

namespace farrier::test {
namespace security_system_test {

constexpr const char* kDuration = "0.4";
constexpr int kBadInput = 2;

/// One set of keys for all tests: each takes a second or two to make.
const std::string& keys() {
  static const ScratchDirectory scratch;
  static const std::string folder = [] {
    std::string output;
    EXPECT_EQ(run_farrier({"security", "init", scratch.file("keys")}, &output), 0) << output;
    return scratch.file("keys");
  }();
  return folder;
}

TEST(SecurityCommand, ChecksWhatItMade) {
  std::string output;
  EXPECT_EQ(run_farrier({"security", "check", keys()}, &output), 0) << output;
}

class SecureTrot : public testing::TestWithParam<const char*> {};

TEST_P(SecureTrot, BeginsAndLeavesTheTraceOfAnOpenOne) {
  static const std::string open = trace_of_trot({"--duration", kDuration, "--dds", "inproc"});
  ASSERT_GT(open.size(), 1000u);
  EXPECT_TRUE(trace_of_trot({"--duration", kDuration, "--dds", GetParam(), "--security", keys()}) == open);
}

// Mixed three times: handshakes between the vendors have more than one way to go wrong.
INSTANTIATE_TEST_SUITE_P(Over, SecureTrot, testing::Values("cyclone", "fast", "mixed", "mixed", "mixed"),
                         [](const auto& dds) { return std::string(dds.param) + std::to_string(dds.index); });

TEST(SecurityCommand, RefusesATrotWithoutTheKeysOfAProcess) {
  const ScratchDirectory scratch;
  const std::string part = scratch.file("keys");
  std::filesystem::copy(keys(), part, std::filesystem::copy_options::recursive);
  std::filesystem::remove_all(part + "/joint_node.fast");
  std::string output;
  EXPECT_EQ(run_farrier({"trot", "--world", "bench", "--dds", "fast", "--security", part, "--out", scratch.file("out")},
                        &output),
            kBadInput);
  EXPECT_NE(output.find("joint_node.fast"), std::string::npos) << output;
  EXPECT_NE(output.find("farrier security init"), std::string::npos) << "what to do: " << output;
  EXPECT_FALSE(std::filesystem::exists(scratch.file("out"))) << "nothing begins";
}

TEST(SecurityCommand, RefusesKeysThatOthersMayRead) {
  const ScratchDirectory scratch;
  const std::string open = scratch.file("keys");
  std::filesystem::copy(keys(), open, std::filesystem::copy_options::recursive);
  std::filesystem::permissions(open + "/supervisor.cyclone/key.pem", std::filesystem::perms::others_read,
                               std::filesystem::perm_options::add);
  std::string output;
  EXPECT_EQ(
      run_farrier({"trot", "--world", "bench", "--dds", "cyclone", "--security", open, "--out", scratch.file("out")},
                  &output),
      kBadInput);
  EXPECT_NE(output.find("chmod 600"), std::string::npos) << output;
}

TEST(SecurityCommand, DoesNotWriteOverKeys) {
  const std::string before = read_file(keys() + "/governance.p7s");
  std::string output;
  EXPECT_EQ(run_farrier({"security", "init", keys()}, &output), kBadInput) << output;
  EXPECT_EQ(read_file(keys() + "/governance.p7s"), before);
}

}  // namespace security_system_test
}  // namespace farrier::test
