#include "bus_cyclone/cyclone_config.hpp"

#include "cyclone_base/cyclone_base.hpp"

namespace farrier::bus_cyclone {
namespace {

// A reliable reader that misses a sample learns of it from the next heartbeat and asks at once: late readers and
// lost datagrams cost tens of milliseconds. Acknowledgements may wait, nothing in a KEEP_LAST writer waits for them.
constexpr const char* kReliableTiming =
    "<HeartbeatInterval min=\"5 ms\" minsched=\"20 ms\" max=\"100 ms\">20 ms</HeartbeatInterval>"
    "<NackDelay>1 ms</NackDelay>"
    "<AckDelay>10 ms</AckDelay>"
    "<PreEmptiveAckDelay>5 ms</PreEmptiveAckDelay>";

// A process that ends waits for readers to acknowledge its last samples, for each of its writers by itself: readers of a
// process that has died never do, and those that live take a heartbeat.
constexpr const char* kLinger = "<WriterLingerDuration>100 ms</WriterLingerDuration>";

// A journal is one piece: in fragments of the usual 1344 bytes it shares a datagram with itself, and is put together again.
constexpr const char* kFragmentSize = "33000 B";
constexpr const char* kMessageSize = "34000 B";

// Announcements go by unicast to every port a process may have, so they are rare; a process that starts
// announces itself at once and everyone answers.
constexpr const char* kAnnouncementPeriod = "5 s";

}  // namespace

std::string cyclone_config(const bus::NetworkOptions& options) {
  using cyclone_base::element;
  const std::string general = "<Interfaces><NetworkInterface address=\"" + options.address + "\"/></Interfaces>" +
                              element("AllowMulticast", "false") + element("Transport", "udp") +
                              element("FragmentSize", kFragmentSize) + element("MaxMessageSize", kMessageSize);
  // Cyclone 0.10 announces itself to this index, too, but does not take it for itself.
  const int max_index = options.max_processes;
  const std::string discovery =
      element("ExternalDomainId", std::to_string(options.domain)) + element("ParticipantIndex", "auto") +
      element("MaxAutoParticipantIndex", std::to_string(max_index)) +
      element("Peers", cyclone_base::peer_elements(options.peers)) + element("SPDPInterval", kAnnouncementPeriod) +
      element("LeaseDuration", std::to_string(options.lease.count()) + " s");
  // Data have a thread of their own, which waits in recvmsg; one thread for all sockets asks select before each datagram.
  // Writers hold samples until they are flushed: those of one tick share a datagram.
  const std::string internal = element("MultipleReceiveThreads", "true") + element("WriteBatch", "true") +
                               kReliableTiming + kLinger + "<SocketReceiveBufferSize max=\"" +
                               std::to_string(bus::kSocketBufferBytes) + " B\"/>";
  return element("CycloneDDS", "<Domain Id=\"any\">" + element("General", general) + element("Discovery", discovery) +
                                   element("Internal", internal) + "</Domain>");
}

}  // namespace farrier::bus_cyclone
