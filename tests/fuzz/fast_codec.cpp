// A sample of Fast DDS from its bytes, as its reader hands them to our type. Stands alone in its file: idlc and
// fastddsgen name their headers alike.

#include "bus_fastdds/cyclone_acknack.hpp"
#include "bus_fastdds/cyclone_handshake.hpp"
#include "bus_fastdds/wire_types.hpp"
#include "tests/fuzz/input.hpp"

namespace farrier::fuzz {
namespace {

using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;

template <class Signal>
void decode(Bytes bytes) {
  bus_fastdds::SignalType<Signal> type;
  Payload payload(static_cast<std::uint32_t>(bytes.size()));
  std::copy(bytes.begin(), bytes.end(), payload.data);
  payload.length = static_cast<std::uint32_t>(bytes.size());
  Signal signal;
  if (!type.deserialize(&payload, &signal)) {
    return;
  }
  eprosima::fastrtps::rtps::InstanceHandle_t key;
  require(type.getKey(&signal, &key, false), "a sample that is read has a key");
  Payload back(type.m_typeSize);
  require(type.serialize(&signal, &back), "a sample that is read can be written");
  Signal again;
  require(type.deserialize(&back, &again) && alike(signal, again), "what came is what would go");
}

}  // namespace

void fast_codec(Bytes bytes) {
  Input input(bytes);
  const std::size_t topic = input.below(kTopicCount);
  with_signal_of(topic, [&]<class Signal>(const Signal&) { decode<Signal>(input.rest()); });
}

void cyclone_datagram(Bytes bytes) {
  // The size of the datagram and nothing behind it, so that a byte too many is seen.
  const std::vector<std::uint8_t> before(bytes.begin(), bytes.end());
  std::vector<std::uint8_t> datagram(before);
  bus_fastdds::translate_cyclone_acknacks(datagram);
  constexpr std::size_t kHeaderBytes = 20;
  const std::size_t kept = std::min(kHeaderBytes, before.size());
  require(std::equal(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(kept), datagram.begin()),
          "the header of a datagram stays as it is");
  require(bus_fastdds::handshake_without_secured(datagram).size() < std::max(datagram.size(), kHeaderBytes),
          "something is left out, or nothing comes");
}

}  // namespace farrier::fuzz
