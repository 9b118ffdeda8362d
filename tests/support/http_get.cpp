#include "tests/support/http_get.hpp"

#include <arpa/inet.h>
#include <httplib.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <random>

namespace farrier::test {
namespace {

// Linux gives connections ports from 32768 on.
constexpr std::uint16_t kLowest = 20'000, kHighest = 32'000;

bool is_free(std::uint16_t port) {
  const int probe = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  place.sin_port = htons(port);
  const bool bound = ::bind(probe, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0;
  ::close(probe);
  return bound;
}

}  // namespace

std::uint16_t free_port() {
  std::random_device random;
  std::uniform_int_distribution<std::uint16_t> draw(kLowest, kHighest);
  std::uint16_t port = draw(random);
  while (!is_free(port)) {
    port = draw(random);
  }
  return port;
}

std::string http_get(std::uint16_t port, const std::string& path) {
  const httplib::Result answer = httplib::Client("127.0.0.1", port).Get(path);
  return answer ? answer->body : "";
}

}  // namespace farrier::test
