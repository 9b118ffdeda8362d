#include "bus_fastdds/gathered_datagram.hpp"

#include <algorithm>

#include "bus_fastdds/rtps_datagram.hpp"

namespace farrier::bus_fastdds {
namespace {

using rtps_datagram::kHeaderBytes;

constexpr std::size_t kMostBytes = 1500 - 20 - 8;  // of a frame, behind the headers of IP and UDP

/// Properties of a message that decide if messages can be joined.
struct Contents {
  bool can_be_followed = true;
  bool names_receiver = false;          ///< for its submessages from there on, and for those of messages behind it
  bool begins_with_receiver = false;
  std::size_t statistics_bytes = 0;     ///< of the last submessage, if they are that
};

Contents contents(std::span<const std::uint8_t> message) {
  Contents found;
  const std::span<std::uint8_t> only_read(const_cast<std::uint8_t*>(message.data()), message.size());
  rtps_datagram::for_each_submessage(only_read, [&](const rtps_datagram::Submessage& submessage) {
    const bool ends_with_datagram = message[submessage.begins + 2] == 0 && message[submessage.begins + 3] == 0;
    const bool secured =
        submessage.kind >= rtps_datagram::kSecurePrefix && submessage.kind < rtps_datagram::kFastStatistics;
    found.can_be_followed = found.can_be_followed && !ends_with_datagram && !secured;
    if (submessage.kind == rtps_datagram::kInfoDestination) {
      found.names_receiver = true;
      found.begins_with_receiver = found.begins_with_receiver || submessage.begins == kHeaderBytes;
    }
    found.statistics_bytes =
        submessage.kind == rtps_datagram::kFastStatistics ? submessage.ends - submessage.begins : 0;
    return true;
  });
  return found;
}

}  // namespace

bool GatheredDatagram::add(std::span<const std::uint8_t> message) {
  if (message.size() <= kHeaderBytes || message.size() > kMostBytes) {
    return false;
  }
  const Contents added = contents(message);
  if (!added.can_be_followed) {
    return false;
  }
  if (empty()) {
    bytes_.assign(message.begin(), message.end());
  } else {
    const std::span<const std::uint8_t> submessages = message.subspan(kHeaderBytes);
    const std::size_t kept_bytes = bytes_.size() - statistics_bytes_;
    const bool of_same_participant = std::equal(message.begin(), message.begin() + kHeaderBytes, bytes_.begin());
    const bool fits = kept_bytes + submessages.size() <= kMostBytes;
    if (!of_same_participant || !fits || (names_receiver_ && !added.begins_with_receiver)) {
      return false;
    }
    bytes_.resize(kept_bytes);
    bytes_.insert(bytes_.end(), submessages.begin(), submessages.end());
  }
  statistics_bytes_ = added.statistics_bytes;
  names_receiver_ = names_receiver_ || added.names_receiver;
  return true;
}

void GatheredDatagram::clear() noexcept {
  bytes_.clear();
  names_receiver_ = false;
  statistics_bytes_ = 0;
}

}  // namespace farrier::bus_fastdds
