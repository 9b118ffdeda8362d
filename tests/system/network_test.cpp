// The whole trot where there is no network but a loopback device without multicast.

#include <gtest/gtest.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>

#include "farrier_command.hpp"

namespace farrier::test {
namespace network_test {

constexpr int kNotPermitted = 77;
constexpr const char* kShort = "0.5";

/// Moves this process to a network of its own; ends it where that is not permitted.
void isolate_network() {
  if (::unshare(CLONE_NEWNET) != 0 && ::unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) {
    std::perror("no network namespace");
    ::_exit(kNotPermitted);
  }
  const int probe = ::socket(AF_INET, SOCK_DGRAM, 0);
  ifreq request{};
  std::strcpy(request.ifr_name, "lo");
  ::ioctl(probe, SIOCGIFFLAGS, &request);
  request.ifr_flags = static_cast<short>((request.ifr_flags | IFF_UP) & ~IFF_MULTICAST);
  if (::ioctl(probe, SIOCSIFFLAGS, &request) != 0) {
    std::perror("loopback cannot be raised");
    ::_exit(kNotPermitted);
  }
  ::close(probe);
}

class LoopbackWithoutMulticast : public testing::TestWithParam<const char*> {};

TEST_P(LoopbackWithoutMulticast, CarriesATrotOfSixteenProcesses) {
  const ScratchDirectory scratch;
  run_farrier(
      {"trot", "--world", "bench", "--dds", "inproc", "--duration", kShort, "--out", scratch.file("in_process")});
  std::string output;
  const int status = run_farrier({"trot", "--world", "bench", "--dds", GetParam(), "--nodes", "per-joint", "--duration",
                                  kShort, "--out", scratch.file("isolated")},
                                 &output, {FARRIER_COMMAND, isolate_network});
  if (status == kNotPermitted) {
    GTEST_SKIP() << output;
  }
  const std::string expected = read_file(scratch.file("in_process/trace.csv"));
  ASSERT_FALSE(expected.empty());
  EXPECT_TRUE(read_file(scratch.file("isolated/trace.csv")) == expected) << output;
}

INSTANTIATE_TEST_SUITE_P(Over, LoopbackWithoutMulticast, testing::Values("cyclone", "fast", "mixed"),
                         [](const auto& dds) { return std::string(dds.param); });

}  // namespace network_test
}  // namespace farrier::test
