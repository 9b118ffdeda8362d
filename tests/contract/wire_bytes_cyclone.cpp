#include <dds/ddsi/ddsi_cdrstream.h>
#include <dds/ddsi/q_protocol.h>

#include "bus_cyclone/wire_types.hpp"
#include "signals/cdr.hpp"
#include "tests/contract/wire_bytes.hpp"

namespace farrier::contract {
namespace {

template <class Signal>
bool read(std::span<const std::uint8_t> bytes, Signal& signal) {
  using Wire = bus_cyclone::Wire<Signal>;
  const auto body = bytes.subspan(signals::kCdrHeadBytes);
  std::vector<std::uint64_t> aligned(body.size() / sizeof(std::uint64_t) + 1);  // Cyclone works in place, in words
  char* const data = reinterpret_cast<char*>(aligned.data());
  std::copy(body.begin(), body.end(), data);
  const auto size = static_cast<std::uint32_t>(body.size());
  std::uint32_t used = 0;
  if (dds_stream_normalize_data(data, &used, size, false, CDR_ENC_VERSION_1, Wire::descriptor().m_ops) == nullptr ||
      used != size) {
    return false;
  }
  dds_istream_t stream;
  dds_istream_init(&stream, size, data, CDR_ENC_VERSION_1);
  typename Wire::Type wire{};
  dds_stream_read(&stream, reinterpret_cast<char*>(&wire), Wire::descriptor().m_ops);
  Wire::copy(signal, wire);
  return true;
}

}  // namespace

#define FARRIER_CYCLONE(Signal, file) \
  bool cyclone_reads(std::span<const std::uint8_t> bytes, signals::Signal& signal) { return read(bytes, signal); }
FARRIER_SIGNALS(FARRIER_CYCLONE)
#undef FARRIER_CYCLONE

}  // namespace farrier::contract
