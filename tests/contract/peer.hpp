#pragma once

// Other processes: this test binary started again in another role, so that it can be killed and stopped.

#include <sys/types.h>

#include <cstdio>
#include <string>
#include <vector>

#include "bus/bus.hpp"

namespace farrier::contract {

/// A process that runs this binary with `arguments`; killed when it goes out of scope.
class Peer {
 public:
  explicit Peer(const std::vector<std::string>& arguments);
  ~Peer();
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  void kill();  ///< SIGKILL: it says goodbye to nobody
  void stop();  ///< SIGSTOP
  /// Next line of its standard output, without the newline; empty at the end.
  std::string read_line();
  /// Closes its standard input, which tells it to leave, and waits; its exit code.
  int finish();

 private:
  pid_t pid_ = -1;
  FILE* output_ = nullptr;
  int input_ = -1;
};

/// QoS of what one supervisor at a time may say.
bus::Qos authority();

/// Starts a process that publishes SystemMode with `strength` as its epoch, and as its ownership strength, every 2 ms.
std::vector<std::string> mode_writer(bus::Vendor vendor, int domain, const std::string& robot, int strength);

/// Starts a process that reads SystemEvent reliably.
std::vector<std::string> event_reader(bus::Vendor vendor, int domain, const std::string& robot);

/// Starts a process that says hello as participant `index` and reports how long it took to hear `count` of them,
/// itself included.
std::vector<std::string> greeter(bus::Vendor vendor, int domain, int index, int count);

/// Starts `count` greeters of alternating vendors on a loopback device without multicast, in a network namespace of
/// their own. It prints "<vendor> <milliseconds>" of each or "skip <reason>".
std::vector<std::string> isolated_greeters(int count);

/// Joints whose samples go together, and how often, in the process of isolated_gatherer().
inline constexpr std::size_t kGatheredJoints = 3;
inline constexpr int kGatheredTicks = 200;

/// Starts a process that writes samples which go together, to a bus of its own, in a network namespace of its own. With
/// `keys` it uses DDS Security with the keys of that folder; empty: without encryption. It prints "<samples received>
/// <datagrams sent>" or "skip <reason>".
std::vector<std::string> isolated_gatherer(bus::Vendor writer, bus::Vendor reader, const std::string& partition,
                                           const std::string& keys);

/// Runs the role `arguments` name; -1 when they name none.
int run_role(const std::vector<std::string>& arguments);

}  // namespace farrier::contract
