#include "tools/monitor/listen_address.hpp"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>

namespace farrier::display {

Result<ListenAddress> parse_listen_address(const std::string& text) {
  const Error refusal{"'" + text +
                      "' is no address to listen on: give :9464 for this computer alone, 0.0.0.0:9464 for all its "
                      "addresses, or one of them, as 192.168.1.5:9464 or [::1]:9464"};
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) {
    return refusal;
  }
  ListenAddress address;
  const char* end = text.data() + text.size();
  const auto [rest, problem] = std::from_chars(text.data() + colon + 1, end, address.port);
  if (problem != std::errc{} || rest != end) {
    return refusal;
  }
  address.ip = text.substr(0, colon);
  address.v6 = address.ip.size() > 2 && address.ip.front() == '[' && address.ip.back() == ']';
  if (address.v6) {
    address.ip = address.ip.substr(1, address.ip.size() - 2);
  } else if (address.ip.empty() || address.ip == "localhost") {
    address.ip = "127.0.0.1";
  }
  unsigned char bytes[sizeof(in6_addr)];
  return ::inet_pton(address.v6 ? AF_INET6 : AF_INET, address.ip.c_str(), bytes) == 1 ? Result<ListenAddress>(address)
                                                                                      : refusal;
}

Result<Done> check_listening(const ListenAddress& address) {
  sockaddr_storage place{};
  socklen_t size = sizeof(sockaddr_in);
  if (address.v6) {
    auto& v6 = reinterpret_cast<sockaddr_in6&>(place);
    v6.sin6_family = AF_INET6;
    v6.sin6_port = htons(address.port);
    ::inet_pton(AF_INET6, address.ip.c_str(), &v6.sin6_addr);
    size = sizeof(sockaddr_in6);
  } else {
    auto& v4 = reinterpret_cast<sockaddr_in&>(place);
    v4.sin_family = AF_INET;
    v4.sin_port = htons(address.port);
    ::inet_pton(AF_INET, address.ip.c_str(), &v4.sin_addr);
  }
  const int probe = ::socket(address.v6 ? AF_INET6 : AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int on = 1;
  ::setsockopt(probe, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  const bool free = probe >= 0 && ::bind(probe, reinterpret_cast<const sockaddr*>(&place), size) == 0 &&
                    ::listen(probe, 1) == 0;
  const int problem = errno;
  if (probe >= 0) {
    ::close(probe);
  }
  return free ? Result<Done>(Done{})
              : Error{"cannot listen on " + address.text() + ": " + std::strerror(problem)};
}

}  // namespace farrier::display
