#include "bus_fastdds/free_index.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace farrier::bus_fastdds {
namespace {

constexpr int kPortBase = 7400;
constexpr int kDomainGain = 250;
constexpr int kIndexGain = 2;
constexpr int kDiscoveryOffset = 10;
constexpr int kDataOffset = 11;

bool is_free(const std::string& address, int port) noexcept {
  const int udp = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (udp < 0) {
    return false;
  }
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(static_cast<std::uint16_t>(port));
  const bool bound = port <= UINT16_MAX && inet_pton(AF_INET, address.c_str(), &name.sin_addr) == 1 &&
                     bind(udp, reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0;
  close(udp);
  return bound;
}

}  // namespace

int free_participant_index(const bus::NetworkOptions& options, int from) noexcept {
  for (int index = from; index < options.max_processes; ++index) {
    const int port = kPortBase + kDomainGain * options.domain + kIndexGain * index;
    if (is_free(options.address, port + kDiscoveryOffset) && is_free(options.address, port + kDataOffset)) {
      return index;
    }
  }
  return -1;
}

}  // namespace farrier::bus_fastdds
