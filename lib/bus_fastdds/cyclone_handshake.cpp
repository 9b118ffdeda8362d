#include "bus_fastdds/cyclone_handshake.hpp"

#include <algorithm>

#include "bus_fastdds/rtps_datagram.hpp"

namespace farrier::bus_fastdds {
namespace {

using namespace rtps_datagram;

// DDS Security 1.1, 7.3.7.4: the writer of ParticipantStatelessMessage, which is never protected.
constexpr std::array<std::uint8_t, 4> kHandshakeWriter{0x00, 0x02, 0x01, 0xc3};
// RTPS 2.2, 9.4.5.3 and 9.4.5.4: flags, offset and reader of DATA and DATA_FRAG stand before the writer.
constexpr std::size_t kWriterOffset = 8;

bool is_handshake(const Submessage& submessage) noexcept {
  const bool has_writer = submessage.kind == kData || submessage.kind == kDataFrag;
  return has_writer && submessage.body.size() >= kWriterOffset + kHandshakeWriter.size() &&
         std::ranges::equal(submessage.body.subspan(kWriterOffset, kHandshakeWriter.size()), kHandshakeWriter);
}

}  // namespace

std::vector<std::uint8_t> handshake_without_secured(std::span<std::uint8_t> datagram) {
  if (!is_from_cyclone(datagram)) {
    return {};
  }
  bool secured_before = false;
  bool found = false;
  for_each_submessage(datagram, [&](const Submessage& submessage) {
    secured_before = secured_before || submessage.kind == kSecurePrefix;
    found = secured_before && is_handshake(submessage);
    return !found && submessage.kind != kSecureRtpsPrefix;
  });
  if (!found) {
    return {};
  }
  std::vector<std::uint8_t> rest(datagram.begin(), datagram.begin() + kHeaderBytes);
  bool secured = false;
  for_each_submessage(datagram, [&](const Submessage& submessage) {
    secured = secured || submessage.kind == kSecurePrefix;
    if (!secured) {
      const auto whole = datagram.subspan(submessage.begins, submessage.ends - submessage.begins);
      rest.insert(rest.end(), whole.begin(), whole.end());
    }
    secured = secured && submessage.kind != kSecurePostfix;
    return true;
  });
  return rest;
}

}  // namespace farrier::bus_fastdds
