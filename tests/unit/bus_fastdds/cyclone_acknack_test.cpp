// The Fast DDS bus's changes to Cyclone's acknowledgements, byte by byte.

#include "bus_fastdds/cyclone_acknack.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/unit/bus_fastdds/rtps_bytes.hpp"

namespace farrier::bus_fastdds {
namespace cyclone_acknack_test {

using namespace testing;

constexpr std::uint8_t kAcknack = 0x06;
constexpr std::uint8_t kHeartbeat = 0x07;
constexpr std::uint8_t kLittleEndian = 0x01;
constexpr std::uint8_t kFinal = 0x02;

/// A datagram of `vendor` with one ACKNACK of no requests, little endian.
std::vector<std::uint8_t> acknack(std::uint8_t vendor, std::uint8_t flags, std::uint8_t base, std::uint8_t count,
                                  std::uint8_t kind = kAcknack) {
  return {'R', 'T', 'P', 'S', 2, 1, 1, vendor, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
          kind, flags, 24, 0, 0, 0, 3, 0xc7, 0, 0, 3, 0xc2, 0, 0, 0, 0, base, 0, 0, 0,
          0, 0, 0, 0, count, 0, 0, 0};
}

std::vector<std::uint8_t> translated(std::vector<std::uint8_t> bytes) {
  translate_cyclone_acknacks(bytes);
  return bytes;
}

TEST(CycloneAcknack, GreetingBecomesFastDdsOwn) {
  EXPECT_EQ(translated(acknack(kCyclone, kLittleEndian, 1, 0)), acknack(kCyclone, kLittleEndian, 0, 1));
}

TEST(CycloneAcknack, LaterOnesOnlyCountOneMore) {
  EXPECT_EQ(translated(acknack(kCyclone, kLittleEndian, 1, 1)), acknack(kCyclone, kLittleEndian, 1, 2));
  EXPECT_EQ(translated(acknack(kCyclone, kLittleEndian | kFinal, 1, 0)), acknack(kCyclone, kLittleEndian | kFinal, 1, 1));
}

TEST(CycloneAcknack, EveryOneInADatagramIsTranslated) {
  std::vector<std::uint8_t> two = acknack(kCyclone, kLittleEndian, 1, 0);
  const std::vector<std::uint8_t> second = acknack(kCyclone, kLittleEndian, 1, 0);
  two.insert(two.end(), second.begin() + 20, second.end());
  translate_cyclone_acknacks(two);
  EXPECT_EQ(two[16 + 20], 0);
  EXPECT_EQ(two[16 + 20 + 28], 0);
}

TEST(CycloneAcknack, NothingElseChanges) {
  for (const auto& bytes : {acknack(kFastDds, kLittleEndian, 1, 0), acknack(kCyclone, kLittleEndian, 1, 0, kHeartbeat)}) {
    EXPECT_EQ(translated(bytes), bytes);
  }
}

TEST(CycloneAcknack, WhatIsSignedStaysAsItIs) {
  for (const std::uint8_t prefix : {std::uint8_t{0x31}, std::uint8_t{0x33}}) {  // of a submessage, of a message
    std::vector<std::uint8_t> bytes = acknack(kCyclone, kLittleEndian, 1, 0);
    const std::vector<std::uint8_t> secured{prefix, kLittleEndian, 4, 0, 0, 0, 0, 0};
    bytes.insert(bytes.begin() + 20, secured.begin(), secured.end());
    EXPECT_EQ(translated(bytes), bytes);
  }
}

TEST(CycloneAcknack, TruncatedDatagramsStayAsTheyAre) {
  const std::vector<std::uint8_t> whole = acknack(kCyclone, kLittleEndian, 1, 0);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::vector<std::uint8_t> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_EQ(translated(cut), cut) << size;
  }
}

}  // namespace cyclone_acknack_test
}  // namespace farrier::bus_fastdds
