#pragma once

// Computers for tests: network namespaces with cables that can be cut. Needs root and iproute2.

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace farrier::test {

/// A descriptor that is closed when it goes.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) noexcept : number_(number) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept;
  int number() const noexcept { return number_; }

 private:
  int number_;
};

/// Computers joined by a bridge, which stands in a namespace of its own: the network of this computer is not touched.
/// The namespaces have no names and hang on descriptors of this process alone, so that they are gone when it ends,
/// however it ends.
class NetworkNamespaces {
 public:
  struct Host {
    std::string name;
    std::string interface;  ///< its only one but lo, without multicast
    std::string address;    ///< of a /24
  };

  /// Why this process can make none, in a sentence; empty when it can.
  static std::string refusal();

  /// Makes the namespaces. A failure fails the test.
  explicit NetworkNamespaces(const std::vector<Host>& hosts);

  /// For Surroundings::prepare: moves a new process to a host, and ends it with the thread that started it.
  std::function<void()> at(const std::string& host) const;

  /// Pulls a host's cable out of the bridge and puts it back: the host's interface is without a carrier meanwhile.
  void cut(const std::string& host) const { set_up(host, false); }
  void restore(const std::string& host) const { set_up(host, true); }

  /// Sets a host's "net/..." of sysctl.
  void set(const std::string& host, const std::string& name, const std::string& value) const;

  /// Takes a host's cable off the bridge and returns its ends, between which the caller has to carry frames from now
  /// on. Both are interfaces in the namespace of the bridge: the first is the host's, the second the bridge's.
  std::pair<std::string, std::string> open_cable(const std::string& host);

  /// Name of the namespace that the bridge is in, for Visit.
  static constexpr const char* kSwitch = "switch";

  /// The calling thread, and what it starts, is on that host while this lives.
  class Visit {
   public:
    Visit(const NetworkNamespaces& network, const std::string& host);
    ~Visit();
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;

   private:
    Descriptor home_;
  };

 private:
  int descriptor_of(const std::string& host) const;
  /// Runs a batch of `ip` there; what it prints.
  std::string ip(const std::string& host, const std::string& batch) const;
  /// Waits until an interface has a carrier, which the kernel tells up to a second late, and its bridge passes frames.
  void await_carrier(const std::string& host, const std::string& interface) const;
  void set_up(const std::string& host, bool up) const;

  std::map<std::string, Descriptor> namespaces_;
  Descriptor switch_socket_;  ///< by which interfaces of the switch are told to be up or down
};

}  // namespace farrier::test
