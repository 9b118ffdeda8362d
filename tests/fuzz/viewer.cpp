#include "tests/fuzz/harness.hpp"
#include "tools/foxglove/viewer.hpp"

namespace farrier::fuzz {

void foxglove_text(Bytes bytes) {
  constexpr std::size_t kChannels = 3;
  foxglove::Subscriptions subscriptions(kChannels);
  const auto outcome = subscriptions.take(text_of(bytes));
  for (const std::size_t channel : outcome.begun) {
    require(channel < kChannels, "a viewer subscribes to channels that are there");
  }
  foxglove::Viewer viewer(kChannels);
  require(viewer.take(text_of(bytes), true) == (bytes.size() <= foxglove::Viewer::kLargestText),
          "a text is refused for its length alone");
  require(viewer.begun() == outcome.begun, "a viewer subscribes to what its text says");
  std::vector<std::uint8_t> answer;
  while (viewer.has_waiting()) {
    require(viewer.pop(answer), "problems are answered by texts");
  }
}

}  // namespace farrier::fuzz
