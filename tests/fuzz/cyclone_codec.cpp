// A sample of Cyclone DDS from its bytes: checked and read by Cyclone's own functions, then copied into our signal.
// Stands alone in its file: idlc and fastddsgen name their headers alike.

#include <dds/ddsi/ddsi_cdrstream.h>
#include <dds/ddsi/q_protocol.h>

#include <vector>

#include "bus_cyclone/wire_types.hpp"
#include "tests/fuzz/input.hpp"

namespace farrier::fuzz {
namespace {

template <class Signal>
void decode(Bytes bytes, bool swapped) {
  using Wire = bus_cyclone::Wire<Signal>;
  std::vector<std::uint64_t> aligned((bytes.size() + 7) / 8 + 1);  // Cyclone works in place, in words
  char* const data = reinterpret_cast<char*>(aligned.data());
  std::copy(bytes.begin(), bytes.end(), data);
  const auto size = static_cast<std::uint32_t>(bytes.size());
  std::uint32_t used = 0;
  if (dds_stream_normalize_data(data, &used, size, swapped, CDR_ENC_VERSION_1, Wire::descriptor().m_ops) == nullptr) {
    return;
  }
  require(used <= size, "Cyclone reads no more than there is");
  dds_istream_t stream;
  dds_istream_init(&stream, size, data, CDR_ENC_VERSION_1);
  typename Wire::Type wire{};
  dds_stream_read(&stream, reinterpret_cast<char*>(&wire), Wire::descriptor().m_ops);
  Signal signal;
  Wire::copy(signal, wire);
  typename Wire::Type back{};
  Wire::copy(back, signal);
  Signal again;
  Wire::copy(again, back);
  require(alike(signal, again), "what came is what would go");
}

}  // namespace

void cyclone_codec(Bytes bytes) {
  Input input(bytes);
  const std::size_t topic = input.below(kTopicCount);
  const bool swapped = input.byte() % 2 != 0;
  with_signal_of(topic, [&]<class Signal>(const Signal&) { decode<Signal>(input.rest(), swapped); });
}

}  // namespace farrier::fuzz
