#pragma once

#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include <atomic>
#include <memory>

namespace farrier::bus_fastdds {

/// UDP, over which samples that go together leave in one datagram (see gathered_sends.hpp), with three corrections that
/// make processes find each other in tens of milliseconds instead of seconds or never:
///
/// - Fast DDS 2.9 announces a participant before it starts to receive, and others answer a newcomer's announcement
///   once. What they answer in between is lost, until their next periodic announcement. Nothing is sent here before
///   `receiving` is set, after which the participant's repeated first announcements go out.
/// - ACKNACKs of Cyclone DDS are translated (see cyclone_acknack.hpp).
/// - What Cyclone sends to end a handshake comes before what Fast DDS cannot decrypt yet (see cyclone_handshake.hpp).
struct FastTransportDescriptor final : eprosima::fastdds::rtps::ChainingTransportDescriptor {
  explicit FastTransportDescriptor(std::shared_ptr<eprosima::fastdds::rtps::UDPv4TransportDescriptor> udp)
      : ChainingTransportDescriptor(std::move(udp)) {}

  eprosima::fastdds::rtps::TransportInterface* create_transport() const override;

  std::shared_ptr<std::atomic<bool>> receiving = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace farrier::bus_fastdds
