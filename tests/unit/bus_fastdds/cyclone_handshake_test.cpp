// When the Fast DDS bus gives Fast DDS a handshake message of Cyclone before the rest of its datagram.

#include "bus_fastdds/cyclone_handshake.hpp"

#include <gtest/gtest.h>

#include "tests/unit/bus_fastdds/rtps_bytes.hpp"

namespace farrier::bus_fastdds {
namespace cyclone_handshake_test {

using namespace testing;

constexpr std::uint8_t kSecureBody = 0x30;
constexpr std::uint8_t kSecurePrefix = 0x31;
constexpr std::uint8_t kSecurePostfix = 0x32;
constexpr std::uint8_t kSecureRtpsPrefix = 0x33;

Bytes data_of(std::uint8_t writer_kind) {
  Bytes bytes = submessage(kData, 20);
  const Bytes writer{0x00, 0x02, 0x01, writer_kind};
  std::ranges::copy(writer, bytes.begin() + 12);
  return bytes;
}

const Bytes kHandshake = data_of(0xc3);
const Bytes kOther = data_of(0xc2);

const std::vector<Bytes> kAsSeen{submessage(kInfoDestination, 12), submessage(kSecurePrefix),  submessage(kSecureBody),
                                 submessage(kSecurePostfix),       submessage(kInfoTimestamp), kHandshake};

TEST(CycloneHandshake, ComesWithoutWhatIsSecuredBeforeIt) {
  Bytes bytes = datagram(kCyclone, kAsSeen);
  const Bytes before = bytes;
  EXPECT_EQ(handshake_without_secured(bytes),
            datagram(kCyclone, {submessage(kInfoDestination, 12), submessage(kInfoTimestamp), kHandshake}));
  EXPECT_EQ(bytes, before) << "the datagram itself is for Fast DDS, too";
}

TEST(CycloneHandshake, KeepsNothingOfAnySecuredGroup) {
  Bytes bytes = datagram(kCyclone, {submessage(kSecurePrefix), kOther, submessage(kSecurePostfix), kHandshake,
                                    submessage(kSecurePrefix), submessage(kSecureBody), submessage(kSecurePostfix)});
  EXPECT_EQ(handshake_without_secured(bytes), datagram(kCyclone, {kHandshake}));
}

TEST(CycloneHandshake, IsNotTakenOutWhereNothingStandsInItsWay) {
  for (const std::vector<Bytes>& parts :
       {std::vector<Bytes>{kHandshake}, {kHandshake, submessage(kSecurePrefix)}, {submessage(kSecurePrefix), kOther},
        {submessage(kSecureRtpsPrefix), kHandshake}}) {
    Bytes bytes = datagram(kCyclone, parts);
    EXPECT_TRUE(handshake_without_secured(bytes).empty());
  }
  Bytes of_fast = datagram(kFastDds, kAsSeen);
  EXPECT_TRUE(handshake_without_secured(of_fast).empty()) << "Fast DDS sends each submessage of a handshake by itself";
}

TEST(CycloneHandshake, TruncatedDatagramsAreNoWorse) {
  const Bytes whole = datagram(kCyclone, kAsSeen);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_LE(handshake_without_secured(cut).size(), size);
  }
}

}  // namespace cyclone_handshake_test
}  // namespace farrier::bus_fastdds
