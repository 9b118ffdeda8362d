// A recording's bytes are those of the wire: both vendors read them, and what Fast DDS sends is read back.

#include "tests/contract/wire_bytes.hpp"

#include <gtest/gtest.h>

#include "signals/cdr.hpp"
#include "tests/contract/random_signal.hpp"

namespace farrier::contract {
namespace wire_bytes_test {

template <class Signal>
void expect_the_same_everywhere(const char* name) {
  SCOPED_TRACE(name);
  std::mt19937_64 random(11);
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < 20; ++i) {
    const auto signal = random_signal<Signal>(random);
    signals::to_cdr(signal, bytes);
    Signal of_cyclone;
    ASSERT_TRUE(cyclone_reads(bytes, of_cyclone));
    EXPECT_EQ(bytes_of(of_cyclone), bytes_of(signal));
    Signal of_fast;
    ASSERT_TRUE(fast_reads(bytes, of_fast));
    EXPECT_EQ(bytes_of(of_fast), bytes_of(signal));
    Signal sent_by_fast;
    ASSERT_TRUE(signals::from_cdr(fast_writes(signal), sent_by_fast));
    EXPECT_EQ(bytes_of(sent_by_fast), bytes_of(signal));
  }
}

TEST(WireBytes, OfEverySignalAreTheSameForBothVendors) {
#define FARRIER_EXPECT(Signal, file) expect_the_same_everywhere<signals::Signal>(#Signal);
  FARRIER_SIGNALS(FARRIER_EXPECT)
#undef FARRIER_EXPECT
}

}  // namespace wire_bytes_test
}  // namespace farrier::contract
