#include "bus_fastdds/fast_transport.hpp"

#include <fastdds/rtps/transport/ChainingTransport.h>

#include "bus_fastdds/cyclone_acknack.hpp"
#include "bus_fastdds/cyclone_handshake.hpp"
#include "bus_fastdds/gathered_sends.hpp"

namespace farrier::bus_fastdds {
namespace {

namespace fast_rtps = eprosima::fastdds::rtps;
using eprosima::fastrtps::rtps::LocatorsIterator;
using eprosima::fastrtps::rtps::octet;
using eprosima::fastrtps::rtps::SenderResource;

class FastTransport final : public fast_rtps::ChainingTransport {
 public:
  explicit FastTransport(const FastTransportDescriptor& descriptor)
      : ChainingTransport(descriptor), descriptor_(descriptor) {}

  fast_rtps::TransportDescriptorInterface* get_configuration() override { return &descriptor_; }

  bool send(SenderResource* udp, const octet* bytes, std::uint32_t size, LocatorsIterator* first,
            LocatorsIterator* last, const std::chrono::steady_clock::time_point& timeout) override {
    if (!descriptor_.receiving->load(std::memory_order_relaxed)) {
      return true;
    }
    if (GatheredSends* together = GatheredSends::of_this_thread()) {
      return together->keep(*udp, {bytes, size}, *first, *last, timeout);
    }
    return udp->send(bytes, size, first, last, timeout);
  }

  void receive(fast_rtps::TransportReceiverInterface* receiver, const octet* bytes, std::uint32_t size,
               const fast_rtps::Locator& local, const fast_rtps::Locator& remote) override {
    // The buffer belongs to the calling thread, which fills it again for every datagram.
    const std::span<octet> datagram(const_cast<octet*>(bytes), size);
    if (translate_cyclone_acknacks(datagram)) {
      if (const std::vector<octet> first = handshake_without_secured(datagram); !first.empty()) {
        receiver->OnDataReceived(first.data(), static_cast<std::uint32_t>(first.size()), local, remote);
      }
    }
    receiver->OnDataReceived(bytes, size, local, remote);
  }

 private:
  FastTransportDescriptor descriptor_;
};

}  // namespace

fast_rtps::TransportInterface* FastTransportDescriptor::create_transport() const { return new FastTransport(*this); }

}  // namespace farrier::bus_fastdds
