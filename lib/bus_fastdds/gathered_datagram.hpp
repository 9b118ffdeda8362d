#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace farrier::bus_fastdds {

/// One RTPS message made of several. A message is a header and any number of submessages (RTPS 2.2, 8.3.3), so the
/// submessages of the next one follow those of the one before. Fast DDS ends each message with statistics; only the
/// last ones stay, because it searches them at a datagram's end.
class GatheredDatagram {
 public:
  /// Appends a copy of a message. Returns false, and changes nothing, if the message cannot follow: it is of another
  /// participant, both together exceed an Ethernet frame, or an earlier message names a receiver, which would apply to
  /// it. Messages that DDS Security has signed or encrypted go alone, and so do messages longer than a frame.
  bool add(std::span<const std::uint8_t> message);

  std::span<const std::uint8_t> bytes() const noexcept { return bytes_; }
  bool empty() const noexcept { return bytes_.empty(); }
  void clear() noexcept;

 private:
  std::vector<std::uint8_t> bytes_;
  bool names_receiver_ = false;
  std::size_t statistics_bytes_ = 0;  ///< at the end
};

}  // namespace farrier::bus_fastdds
