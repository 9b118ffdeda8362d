// Which RTPS messages follow one another in a datagram of the Fast DDS bus, byte by byte.

#include "bus_fastdds/gathered_datagram.hpp"

#include <gtest/gtest.h>

#include "tests/unit/bus_fastdds/rtps_bytes.hpp"

namespace farrier::bus_fastdds {
namespace gathered_datagram_test {

using namespace testing;

constexpr std::size_t kHeaderBytes = 20;
constexpr std::uint8_t kFastStatistics = 0x80;

Bytes contents(const GatheredDatagram& datagram) { return {datagram.bytes().begin(), datagram.bytes().end()}; }

Bytes sample(std::uint8_t filling) { return joined({header(), submessage(kInfoTimestamp, 8), submessage(kData, 40, filling)}); }

TEST(GatheredDatagram, SubmessagesFollowThoseOfTheMessageBefore) {
  GatheredDatagram datagram;
  EXPECT_TRUE(datagram.empty());
  ASSERT_TRUE(datagram.add(sample(1)));
  EXPECT_EQ(contents(datagram), sample(1));
  ASSERT_TRUE(datagram.add(sample(2)));
  EXPECT_EQ(contents(datagram), joined({header(), submessage(kInfoTimestamp, 8), submessage(kData, 40, 1),
                                        submessage(kInfoTimestamp, 8), submessage(kData, 40, 2)}));
  datagram.clear();
  EXPECT_TRUE(datagram.empty());
  EXPECT_TRUE(datagram.add(joined({header(kFastDds, 2), submessage(kData, 40)})));
}

TEST(GatheredDatagram, OnlyTheLastStatisticsOfFastDdsStay) {
  const auto with_statistics = [](std::uint8_t filling) {
    return joined({sample(filling), submessage(kFastStatistics, 56, filling)});
  };
  GatheredDatagram datagram;
  ASSERT_TRUE(datagram.add(with_statistics(1)));
  ASSERT_TRUE(datagram.add(with_statistics(2)));
  EXPECT_EQ(contents(datagram), joined({sample(1), submessage(kInfoTimestamp, 8), submessage(kData, 40, 2),
                                        submessage(kFastStatistics, 56, 2)}));
  ASSERT_TRUE(datagram.add(sample(3)));
  EXPECT_EQ(contents(datagram), joined({sample(1), submessage(kInfoTimestamp, 8), submessage(kData, 40, 2),
                                        submessage(kInfoTimestamp, 8), submessage(kData, 40, 3)}));
}

TEST(GatheredDatagram, OfOneParticipant) {
  GatheredDatagram datagram;
  ASSERT_TRUE(datagram.add(sample(1)));
  EXPECT_FALSE(datagram.add(joined({header(kFastDds, 2), submessage(kData, 40)})));
  EXPECT_EQ(contents(datagram), sample(1));
}

TEST(GatheredDatagram, WhatIsForOneReceiverIsFollowedOnlyByWhatNamesItsOwn) {
  const Bytes named = joined({header(), submessage(kInfoDestination, 12, 7), submessage(kData, 40)});
  GatheredDatagram datagram;
  ASSERT_TRUE(datagram.add(sample(1)));
  ASSERT_TRUE(datagram.add(named));
  EXPECT_FALSE(datagram.add(sample(2)));
  EXPECT_FALSE(datagram.add(joined({header(), submessage(kData, 40), submessage(kInfoDestination, 12, 7)})));
  EXPECT_TRUE(datagram.add(named));
  datagram.clear();
  EXPECT_TRUE(datagram.add(sample(1)));
  EXPECT_TRUE(datagram.add(sample(2)));
}

TEST(GatheredDatagram, FitsIntoAFrameOfEthernet) {
  GatheredDatagram datagram;
  const Bytes message = joined({header(), submessage(kData, 200)});
  int added = 0;
  while (datagram.add(message)) {
    ++added;
  }
  EXPECT_EQ(added, 7);  // 20 + 7 * 204 bytes, and 28 of IP and UDP
  EXPECT_LE(datagram.bytes().size() + 28, 1500u);
  GatheredDatagram another;
  Bytes long_message = header();
  for (int i = 0; i < 8; ++i) {
    long_message = joined({long_message, submessage(kData, 200)});
  }
  EXPECT_FALSE(another.add(long_message));
}

TEST(GatheredDatagram, WhatIsSignedOrWithoutALengthGoesAlone) {
  for (const std::uint8_t prefix : {std::uint8_t{0x31}, std::uint8_t{0x33}}) {  // of a submessage, of a message
    GatheredDatagram datagram;
    EXPECT_FALSE(datagram.add(joined({header(), submessage(prefix, 20), submessage(kData, 40)})));
  }
  GatheredDatagram datagram;
  EXPECT_FALSE(datagram.add(joined({header(), submessage(kData, 0), Bytes(40, 0)})));
  EXPECT_FALSE(datagram.add(header()));
  EXPECT_TRUE(datagram.empty());
}

}  // namespace gathered_datagram_test
}  // namespace farrier::bus_fastdds
