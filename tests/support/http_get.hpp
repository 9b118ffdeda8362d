#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <string>

namespace farrier::test {

/// A port of this computer that nobody listens on just now.
inline std::uint16_t free_port() {
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

/// Body of what a server of this computer answers; empty when none does.
inline std::string http_get(std::uint16_t port, const std::string& path) {
  const int connection = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  place.sin_port = htons(port);
  std::string answer;
  if (::connect(connection, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0) {
    const std::string request = "GET " + path + " HTTP/1.0\r\nHost: localhost\r\n\r\n";
    ::send(connection, request.data(), request.size(), MSG_NOSIGNAL);
    char bytes[4096];
    for (ssize_t count = ::recv(connection, bytes, sizeof bytes, 0); count > 0;
         count = ::recv(connection, bytes, sizeof bytes, 0)) {
      answer.append(bytes, static_cast<std::size_t>(count));
    }
  }
  ::close(connection);
  const std::size_t body = answer.find("\r\n\r\n");
  return body == std::string::npos ? "" : answer.substr(body + 4);
}

}  // namespace farrier::test
