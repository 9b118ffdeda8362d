#pragma once

#include <fastdds/rtps/common/Locator.h>
#include <fastdds/rtps/common/LocatorsIterator.hpp>
#include <fastdds/rtps/network/SenderResource.h>

#include <chrono>
#include <vector>

#include "bus_fastdds/gathered_datagram.hpp"

namespace farrier::bus_fastdds {

/// Messages of a writer, kept until they go together: a datagram costs both sides more than the samples in it. Used by
/// one thread at a time.
class GatheredSends {
 public:
  /// While it lives, the transport gives `sends` the messages of this thread.
  class Scope {
   public:
    explicit Scope(GatheredSends& sends) noexcept;
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
  };
  /// Returns the object of the scope this thread is in, or null.
  static GatheredSends* of_this_thread() noexcept;

  /// Keeps a copy of a message to these receivers, whose sending may last until `until`. Earlier messages are sent now
  /// if they cannot go together with it. The message itself is sent now if it can go with no other. Returns false if
  /// the transport refused to send.
  bool keep(eprosima::fastrtps::rtps::SenderResource& udp, std::span<const std::uint8_t> message,
            eprosima::fastrtps::rtps::LocatorsIterator& first, const eprosima::fastrtps::rtps::LocatorsIterator& last,
            std::chrono::steady_clock::time_point until);

  /// Sends the kept messages by the participant's sender it was given, which must still be there.
  bool send() noexcept;

 private:
  bool transmit(std::span<const std::uint8_t> bytes) noexcept;

  GatheredDatagram datagram_;
  eprosima::fastrtps::rtps::SenderResource* udp_ = nullptr;
  std::vector<eprosima::fastrtps::rtps::Locator_t> receivers_, next_receivers_;
  std::chrono::steady_clock::time_point until_;
};

}  // namespace farrier::bus_fastdds
