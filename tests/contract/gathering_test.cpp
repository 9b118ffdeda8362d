// Samples that go together are one datagram, for every vendor of writer and reader, encrypted or not.

#include <gtest/gtest.h>

#include <sstream>
#include <tuple>

#include "buses.hpp"
#include "peer.hpp"
#include "tests/unit/security/pki.hpp"

namespace farrier::contract {
namespace gathering_test {

constexpr int kOthers = 40;  // datagrams of announcements and the like in the second this takes

using Way = std::tuple<bus::Vendor, bus::Vendor, bool>;

class Gathering : public testing::TestWithParam<Way> {};

std::string keys() {
  static const test::Pki pki;
  return pki.out();
}

TEST_P(Gathering, SamplesOfOneFlushAreOneDatagram) {
  const auto [writer, reader, secured] = GetParam();
  if (!available(writer) || !available(reader)) {
    GTEST_SKIP() << "this build has no Fast DDS";
  }
  Peer gatherer(isolated_gatherer(writer, reader, bus::partition(test::kRobot, "lf"), secured ? keys() : ""));
  const std::string line = gatherer.read_line();
  if (line.rfind("skip", 0) == 0) {
    GTEST_SKIP() << line;
  }
  std::istringstream words(line);
  std::size_t heard = 0;
  int datagrams = -1;
  words >> heard >> datagrams;
  EXPECT_EQ(heard, kGatheredTicks * kGatheredJoints) << line;
  EXPECT_GE(datagrams, kGatheredTicks) << line;
  EXPECT_LE(datagrams, kGatheredTicks + kOthers) << line;
}

INSTANTIATE_TEST_SUITE_P(Pairs, Gathering,
                         testing::Combine(testing::Values(bus::Vendor::kCyclone, bus::Vendor::kFast),
                                          testing::Values(bus::Vendor::kCyclone, bus::Vendor::kFast), testing::Bool()),
                         [](const testing::TestParamInfo<Way>& way) {
                           return std::string(to_string(std::get<0>(way.param))) + "To" +
                                  to_string(std::get<1>(way.param)) + (std::get<2>(way.param) ? "Encrypted" : "");
                         });

}  // namespace gathering_test
}  // namespace farrier::contract
