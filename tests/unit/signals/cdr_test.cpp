#include "signals/cdr.hpp"

#include <gtest/gtest.h>

#include "signals/sequence_of.hpp"
#include "tests/contract/random_signal.hpp"

namespace farrier::signals {
namespace cdr_test {

template <class Signal>
class SignalCdr : public testing::Test {};

#define FARRIER_TYPE(Signal, file) , Signal
template <class, class... Signals>
using TypesBehind = testing::Types<Signals...>;
TYPED_TEST_SUITE(SignalCdr, TypesBehind<void FARRIER_SIGNALS(FARRIER_TYPE)>);
#undef FARRIER_TYPE

TYPED_TEST(SignalCdr, ComesBackAsItWent) {
  std::mt19937_64 random(7);
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < 20; ++i) {
    const auto signal = contract::random_signal<TypeParam>(random);
    to_cdr(signal, bytes);
    TypeParam back;
    ASSERT_TRUE(from_cdr(bytes, back));
    EXPECT_EQ(contract::bytes_of(back), contract::bytes_of(signal));
  }
}

TYPED_TEST(SignalCdr, RefusesBytesOfAnotherLengthOrEncoding) {
  std::vector<std::uint8_t> bytes;
  to_cdr(TypeParam{}, bytes);
  TypeParam back;
  const std::span<const std::uint8_t> all = bytes;
  EXPECT_FALSE(from_cdr(all.first(all.size() - 1), back));
  EXPECT_FALSE(from_cdr({}, back));
  bytes[1] = 0;  // big-endian
  EXPECT_FALSE(from_cdr(bytes, back));
  bytes[1] = 1;
  bytes.resize(bytes.size() + 4);
  EXPECT_FALSE(from_cdr(bytes, back));
}

// The struct of idl/clock_tick.idl: two bytes, padding up to eight, eight bytes.
TEST(SignalCdrBytes, LieAtMultiplesOfTheirSize) {
  std::vector<std::uint8_t> bytes;
  to_cdr(ClockTick{.clock = 0x0102, .tick = 0x0a}, bytes);
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0, 1, 0, 0, 2, 1, 0, 0, 0, 0, 0, 0, 0x0a, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(Sequence, IsOfStreamsAndOfWhatIsCounted) {
  EXPECT_EQ(sequence_of(JointMeasurement{.tick = 5}), 5u);
  EXPECT_EQ(sequence_of(SystemEvent{.count = 3}), 3u);
  EXPECT_EQ(sequence_of(SystemMode{.epoch = 2}), 2u);
  EXPECT_FALSE(sequence_of(JointMeasurement{}).has_value());  // a probe of the greeting
  EXPECT_FALSE(sequence_of(SystemHello{}).has_value());
  EXPECT_FALSE(sequence_of(JointModelEstimate{.tick = 5}).has_value());
}

}  // namespace cdr_test
}  // namespace farrier::signals
