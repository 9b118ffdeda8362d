#include "tests/support/frame_relay.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <linux/if_packet.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <map>
#include <vector>

#include "runtime/realtime_thread.hpp"

namespace farrier::test {
namespace {

using Clock = std::chrono::steady_clock;

/// A frame behind what the kernel says of its checksum and segments, which both ends of the relay pass on.
using Frame = std::vector<std::byte>;
constexpr std::size_t kFrontMatter = 10;  // struct virtio_net_hdr of linux/virtio_net.h, which is no C++
constexpr std::size_t kLongestFrame = kFrontMatter + ETH_HLEN + 65536;

/// All frames that come to an interface of the calling thread's namespace.
Descriptor open_interface(const std::string& name) {
  Descriptor opened(::socket(AF_PACKET, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, htons(ETH_P_ALL)));
  const int on = 1;
  ::setsockopt(opened.number(), SOL_PACKET, PACKET_VNET_HDR, &on, sizeof on);
  ::setsockopt(opened.number(), SOL_PACKET, PACKET_IGNORE_OUTGOING, &on, sizeof on);
  const int loses_nothing = 16 << 20;
  ::setsockopt(opened.number(), SOL_SOCKET, SO_RCVBUFFORCE, &loses_nothing, sizeof loses_nothing);
  sockaddr_ll address{};
  address.sll_family = AF_PACKET;
  address.sll_protocol = htons(ETH_P_ALL);
  address.sll_ifindex = static_cast<int>(::if_nametoindex(name.c_str()));
  EXPECT_EQ(::bind(opened.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0)
      << name << ": " << std::strerror(errno);
  return opened;
}

bool is_ipv4(const Frame& frame) {
  std::uint16_t type = 0;
  std::memcpy(&type, frame.data() + kFrontMatter + offsetof(ether_header, ether_type), sizeof type);
  return type == htons(ETHERTYPE_IP);
}

/// One way through the relay.
class Way {
 public:
  Way(const Impairment& impairment, int from, int to, const char* name)
      : impairment_(impairment),
        from_(from),
        to_(to),
        loss_(impairment.seed, name, "loss"),
        delay_(impairment.seed, name, "delay"),
        duplicate_(impairment.seed, name, "duplicate"),
        reorder_(impairment.seed, name, "reorder") {}

  /// Takes what has come; how many packets, and how many of them are lost.
  std::pair<int, int> take() {
    int packets = 0;
    int lost = 0;
    for (ssize_t length; (length = ::recv(from_, buffer_.data(), buffer_.size(), 0)) > 0;) {
      const Frame frame(buffer_.begin(), buffer_.begin() + length);
      if (!is_ipv4(frame)) {
        send(frame);
        continue;
      }
      ++packets;
      lost += take(frame) ? 0 : 1;
    }
    return {packets, lost};
  }

  /// Sends what is due; when the next is, at most `latest`.
  Clock::time_point send_due(Clock::time_point latest) {
    const auto now = Clock::now();
    while (!waiting_.empty() && waiting_.begin()->first <= now) {
      send(waiting_.begin()->second);
      waiting_.erase(waiting_.begin());
    }
    return waiting_.empty() ? latest : std::min(latest, waiting_.begin()->first);
  }

 private:
  bool take(const Frame& frame) {
    const Tick n = count_++;
    if (loss_.uniform(n) < impairment_.loss) {
      return false;
    }
    const std::chrono::duration<double, std::nano> jitter = delay_.uniform(n) * (impairment_.most - impairment_.least);
    auto due = Clock::now() + impairment_.least + std::chrono::duration_cast<Nanoseconds>(jitter);
    if (reorder_.uniform(n) < impairment_.reorder) {
      due += Impairment::kHeld;
    } else {
      due = in_order_ = std::max(due, in_order_);
    }
    for (int copies = duplicate_.uniform(n) < impairment_.duplicate ? 2 : 1; copies > 0; --copies) {
      waiting_.emplace(due, frame);
    }
    return true;
  }

  void send(const Frame& frame) const { static_cast<void>(::send(to_, frame.data(), frame.size(), 0)); }

  const Impairment& impairment_;
  int from_, to_;
  NoiseStream loss_, delay_, duplicate_, reorder_;
  Frame buffer_ = Frame(kLongestFrame);
  Tick count_ = 0;
  Clock::time_point in_order_{};
  std::multimap<Clock::time_point, Frame> waiting_;  ///< of equal times in the order in which they came
};

}  // namespace

FrameRelay::FrameRelay(NetworkNamespaces& network, const std::string& host, const Impairment& impairment)
    : impairment_(impairment), ends_(::eventfd(0, EFD_CLOEXEC)) {
  const auto [towards_host, towards_bridge] = network.open_cable(host);
  const NetworkNamespaces::Visit visit(network, NetworkNamespaces::kSwitch);
  thread_ = std::thread([this, host_end = open_interface(towards_host), bridge_end = open_interface(towards_bridge)] {
    static_cast<void>(runtime::set_priority(runtime::kWatchPriority));
    carry(host_end.number(), bridge_end.number());
  });
}

FrameRelay::~FrameRelay() {
  ::eventfd_write(ends_.number(), 1);
  thread_.join();
}

void FrameRelay::carry(int towards_host, int towards_bridge) {
  Way ways[] = {{impairment_, towards_host, towards_bridge, "from host"},
                {impairment_, towards_bridge, towards_host, "to host"}};
  for (;;) {
    auto next = Clock::now() + std::chrono::seconds(1);
    for (Way& way : ways) {
      next = way.send_due(next);
    }
    const Nanoseconds rest = std::max(Nanoseconds(next - Clock::now()), Nanoseconds(0));
    const timespec timeout{rest.count() / 1'000'000'000, rest.count() % 1'000'000'000};
    pollfd ready[] = {{towards_host, POLLIN, 0}, {towards_bridge, POLLIN, 0}, {ends_.number(), POLLIN, 0}};
    ::ppoll(ready, std::size(ready), &timeout, nullptr);
    if (ready[2].revents != 0) {
      return;
    }
    for (Way& way : ways) {
      const auto [packets, lost] = way.take();
      packets_ += static_cast<std::uint64_t>(packets);
      lost_ += static_cast<std::uint64_t>(lost);
    }
  }
}

}  // namespace farrier::test
