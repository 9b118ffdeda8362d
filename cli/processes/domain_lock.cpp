#include "cli/processes/domain_lock.hpp"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>

namespace farrier::cli {
namespace {

constexpr int kFirstDomain = 1;
constexpr int kLastDomain = 100;

/// Last of the 250 ports that belong to a domain (RTPS 2.3, 9.6.1.1); participants count up from the first.
std::uint16_t lock_port(int domain) { return static_cast<std::uint16_t>(7400 + 250 * domain + 249); }

}  // namespace

Result<DomainLock> DomainLock::acquire() {
  for (int domain = kFirstDomain; domain <= kLastDomain; ++domain) {
    const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(lock_port(domain));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (socket >= 0 && ::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
      return DomainLock(domain, socket);
    }
    if (socket >= 0) {
      ::close(socket);
    }
  }
  return Error{"no DDS domain between 1 and 100 is free on this computer: end other runs, and see that lo is up"};
}

DomainLock::DomainLock(DomainLock&& other) noexcept : domain_(other.domain_), socket_(other.socket_) {
  other.socket_ = -1;
}

DomainLock::~DomainLock() {
  if (socket_ >= 0) {
    ::close(socket_);
  }
}

}  // namespace farrier::cli
