// The contract that processes compare by its hash, and the keys of topics.

#include <gtest/gtest.h>

#include "bus/key.hpp"
#include "bus/topics.hpp"
#include "signals/fields.hpp"

namespace farrier::contract {
namespace contract_text_test {

constexpr std::size_t kMaxKeySize = 16;  // a longer key travels as a hash, which Cyclone cannot turn back

template <class Signal>
std::size_t key_size() {
  std::size_t size = 0;
  std::size_t index = 0;
  signals::visit_fields(Signal{}, [&](const char*, const auto& field) {
    size += index++ < signals::kTopicText<Signal>.key_fields ? sizeof(field) : 0;
  });
  return size;
}

TEST(Contract, TextThatIsHashedHasTypesArraySizesAndKeys) {
  const std::string text = bus::contract_text();
  for (const char* part : {"joint/model_estimate, version ", "wire::JointModelEstimate: @key unsigned short joint;",
                           " double a[9];", "sequence<octet, 32000> bytes;"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in:\n" << text;
  }
}

TEST(Contract, KeysFitWhereBothVendorsCarryThemInFull) {
#define FARRIER_KEY_SIZE(Signal, file) EXPECT_LE(key_size<signals::Signal>(), kMaxKeySize) << #Signal;
  FARRIER_SIGNALS(FARRIER_KEY_SIZE)
#undef FARRIER_KEY_SIZE
}

}  // namespace contract_text_test
}  // namespace farrier::contract
