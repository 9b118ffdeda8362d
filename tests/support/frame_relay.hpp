#pragma once

// A bad cable: what only the network can do to datagrams, discovery, heartbeats and acknowledgements included.

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "core/noise.hpp"
#include "core/time.hpp"
#include "tests/support/network_namespaces.hpp"

namespace farrier::test {

/// Impairments of the IPv4 packets of a cable, for each direction by itself. All other frames, ARP above all, pass at
/// once. By seed: the n-th packet of a direction is treated the same on every computer.
struct Impairment {
  double loss = 0;                 ///< probability
  Nanoseconds least{0}, most{0};   ///< delay, even between them; packets keep their order
  double duplicate = 0;            ///< probability to come twice
  double reorder = 0;              ///< probability to be held for kHeld more, while others pass
  std::uint64_t seed = 1;

  static constexpr Nanoseconds kHeld = std::chrono::milliseconds(2);
};

/// Carries every frame between the two ends of a host's cable while it lives.
class FrameRelay {
 public:
  FrameRelay(NetworkNamespaces& network, const std::string& host, const Impairment& impairment);
  ~FrameRelay();
  FrameRelay(const FrameRelay&) = delete;
  FrameRelay& operator=(const FrameRelay&) = delete;

  /// Packets so far, both ways.
  std::uint64_t packets() const noexcept { return packets_; }
  std::uint64_t lost() const noexcept { return lost_; }

 private:
  void carry(int towards_host, int towards_bridge);

  Impairment impairment_;
  Descriptor ends_;  ///< readable when the thread is to end
  std::atomic<std::uint64_t> packets_{0}, lost_{0};
  std::thread thread_;
};

}  // namespace farrier::test
