#include "bus/settings/peer_address.hpp"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>

#include <memory>

namespace farrier::bus {
namespace {

bool is_v4(const std::string& text) {
  in_addr bytes{};
  return ::inet_pton(AF_INET, text.c_str(), &bytes) == 1;
}

bool is_v6(const std::string& text) {
  const bool brackets = text.size() > 2 && text.front() == '[' && text.back() == ']';
  std::string plain = brackets ? text.substr(1, text.size() - 2) : text;
  plain = plain.substr(0, plain.find('%'));  // fe80::1%eth0
  in6_addr bytes{};
  return ::inet_pton(AF_INET6, plain.c_str(), &bytes) == 1;
}

Error v6_refused(const std::string& text) {
  return Error{"'" + text + "' is an IPv6 address, and DDS uses IPv4 here: give an IPv4 address, as 192.168.1.5"};
}

}  // namespace

Result<Done> check_address(const std::string& address) {
  if (is_v6(address)) {
    return v6_refused(address);
  }
  if (!is_v4(address)) {
    return Error{"'" + address + "' is no IPv4 address: give one of this computer's, as 192.168.1.5 (ip -4 address)"};
  }
  return Done{};
}

Result<std::string> resolve_peer(const std::string& peer) {
  if (is_v4(peer)) {
    return peer;
  }
  if (peer == "localhost") {  // also where no /etc/hosts has it (RFC 6761, 6.3)
    return std::string("127.0.0.1");
  }
  if (is_v6(peer)) {
    return v6_refused(peer);
  }
  addrinfo wanted{};
  wanted.ai_family = AF_INET;
  wanted.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  const int problem = peer.empty() ? EAI_NONAME : ::getaddrinfo(peer.c_str(), nullptr, &wanted, &found);
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owner(found, [](addrinfo* list) {
    if (list != nullptr) {
      ::freeaddrinfo(list);
    }
  });
  if (problem != 0 || found == nullptr) {
    return Error{"'" + peer + "' does not resolve (" + ::gai_strerror(problem) +
                 "): give an IPv4 address, as 192.168.1.5, or a name that 'getent ahostsv4 " + peer + "' finds"};
  }
  char text[INET_ADDRSTRLEN] = {};
  ::inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(found->ai_addr)->sin_addr, text, sizeof text);
  return std::string(text);
}

std::string address_error(const std::string& address) {
  const auto checked = check_address(address);
  return checked ? "" : checked.error().message;
}

std::string peer_error(const std::string& peer) {
  const auto resolved = resolve_peer(peer);
  return resolved ? "" : resolved.error().message;
}

Result<NetworkOptions> resolve(NetworkOptions network) {
  FARRIER_TRY(check_address(network.address));
  for (std::string& peer : network.peers) {
    peer = FARRIER_TRY(resolve_peer(peer));
  }
  return network;
}

}  // namespace farrier::bus
