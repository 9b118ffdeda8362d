#include "bus_fastdds/gathered_sends.hpp"

#include <fastdds/rtps/common/LocatorList.hpp>

namespace farrier::bus_fastdds {
namespace {

namespace rtps = eprosima::fastrtps::rtps;

thread_local GatheredSends* of_thread = nullptr;

}  // namespace

GatheredSends::Scope::Scope(GatheredSends& sends) noexcept { of_thread = &sends; }

GatheredSends::Scope::~Scope() { of_thread = nullptr; }

GatheredSends* GatheredSends::of_this_thread() noexcept { return of_thread; }

bool GatheredSends::keep(rtps::SenderResource& udp, std::span<const std::uint8_t> message,
                         rtps::LocatorsIterator& first, const rtps::LocatorsIterator& last,
                         std::chrono::steady_clock::time_point until) {
  next_receivers_.clear();
  for (; first != last; ++first) {
    next_receivers_.push_back(*first);
  }
  if (&udp == udp_ && next_receivers_ == receivers_ && datagram_.add(message)) {
    until_ = until;
    return true;
  }
  const bool sent = send();
  udp_ = &udp;
  until_ = until;
  receivers_.swap(next_receivers_);
  return (datagram_.add(message) || transmit(message)) && sent;
}

bool GatheredSends::send() noexcept {
  if (datagram_.empty()) {
    return true;
  }
  const bool sent = transmit(datagram_.bytes());
  datagram_.clear();
  return sent;
}

bool GatheredSends::transmit(std::span<const std::uint8_t> bytes) noexcept {
  rtps::Locators first(receivers_.cbegin()), last(receivers_.cend());
  return udp_->send(bytes.data(), static_cast<std::uint32_t>(bytes.size()), &first, &last, until_);
}

}  // namespace farrier::bus_fastdds
