#include "bus_fastdds/wire_types.hpp"
#include "tests/contract/wire_bytes.hpp"

namespace farrier::contract {
namespace {

using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;

template <class Signal>
bool read(std::span<const std::uint8_t> bytes, Signal& signal) {
  bus_fastdds::SignalType<Signal> type;
  Payload payload(static_cast<std::uint32_t>(bytes.size()));
  std::copy(bytes.begin(), bytes.end(), payload.data);
  payload.length = static_cast<std::uint32_t>(bytes.size());
  return type.deserialize(&payload, &signal);
}

template <class Signal>
std::vector<std::uint8_t> written(const Signal& signal) {
  bus_fastdds::SignalType<Signal> type;
  Payload payload(type.m_typeSize);
  Signal copy = signal;
  if (!type.serialize(&copy, &payload)) {
    return {};
  }
  return {payload.data, payload.data + payload.length};
}

}  // namespace

#define FARRIER_FAST(Signal, file)                                                                                   \
  bool fast_reads(std::span<const std::uint8_t> bytes, signals::Signal& signal) { return read(bytes, signal); }      \
  std::vector<std::uint8_t> fast_writes(const signals::Signal& signal) { return written(signal); }
FARRIER_SIGNALS(FARRIER_FAST)
#undef FARRIER_FAST

}  // namespace farrier::contract
