#include "tests/support/http_get.hpp"

#include <arpa/inet.h>
#include <httplib.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace farrier::test {

std::uint16_t free_port() {
  const int probe = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof place;
  ::bind(probe, reinterpret_cast<const sockaddr*>(&place), size);
  ::getsockname(probe, reinterpret_cast<sockaddr*>(&place), &size);
  ::close(probe);
  return ntohs(place.sin_port);
}

std::string http_get(std::uint16_t port, const std::string& path) {
  const httplib::Result answer = httplib::Client("127.0.0.1", port).Get(path);
  return answer ? answer->body : "";
}

}  // namespace farrier::test
