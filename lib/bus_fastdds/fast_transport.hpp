#pragma once

#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include <atomic>
#include <memory>

namespace farrier::bus_fastdds {

/// UDP transport that sends samples that go together in one datagram (see gathered_sends.hpp). Three corrections make
/// processes find each other in tens of milliseconds instead of seconds or never.
///
/// - Fast DDS 2.9 announces a participant before it starts to receive, and others answer a newcomer's announcement
///   once. Their answers in between are lost, until their next periodic announcement. Nothing is sent here before
///   `receiving` is set. The participant's repeated first announcements go out after that.
/// - ACKNACKs of Cyclone DDS are translated (see cyclone_acknack.hpp).
/// - Cyclone's last message of a handshake is delivered before messages that Fast DDS cannot decrypt yet (see
///   cyclone_handshake.hpp).
struct FastTransportDescriptor final : eprosima::fastdds::rtps::ChainingTransportDescriptor {
  explicit FastTransportDescriptor(std::shared_ptr<eprosima::fastdds::rtps::UDPv4TransportDescriptor> udp)
      : ChainingTransportDescriptor(std::move(udp)) {}

  eprosima::fastdds::rtps::TransportInterface* create_transport() const override;

  std::shared_ptr<std::atomic<bool>> receiving = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace farrier::bus_fastdds
