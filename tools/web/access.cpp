#include "tools/web/access.hpp"

#include <arpa/inet.h>
#include <sys/random.h>

#include <array>

#include "core/ensure.hpp"
#include "core/text.hpp"

namespace farrier::web {
namespace {

bool is_ip(const std::string& text, int family) {
  unsigned char bytes[sizeof(in6_addr)];
  return ::inet_pton(family, text.c_str(), bytes) == 1;
}

}  // namespace

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  FARRIER_ENSURE(::getrandom(bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()), "no random numbers");
  std::string token;
  for (const unsigned char byte : bytes) {
    token += "0123456789abcdef"[byte >> 4];
    token += "0123456789abcdef"[byte & 15];
  }
  return token;
}

bool equal(std::string_view one, std::string_view other) noexcept {
  if (one.size() != other.size()) {
    return false;
  }
  unsigned char difference = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    difference = static_cast<unsigned char>(difference | (one[i] ^ other[i]));
  }
  return difference == 0;
}

bool is_loopback(std::string_view ip) { return ip.substr(0, 4) == "127." || ip == "::1"; }

bool host_is_ours(std::string_view host, bool loopback, std::string_view own_name) {
  std::string name = lower(host);
  if (!name.empty() && name.front() == '[') {
    const std::size_t end = name.find(']');
    if (end == std::string::npos || (end + 1 < name.size() && name[end + 1] != ':')) {
      return false;
    }
    name = name.substr(1, end - 1);
    return is_ip(name, AF_INET6) && (!loopback || is_loopback(name));
  }
  name = name.substr(0, name.find(':'));
  if (name == "localhost") {
    return true;
  }
  if (is_ip(name, AF_INET)) {
    return !loopback || is_loopback(name);
  }
  return !loopback && !own_name.empty() && (name == own_name || name == std::string(own_name) + ".local");
}

std::string_view cookie(std::string_view header, std::string_view name) {
  while (!header.empty()) {
    const std::size_t end = header.find(';');
    std::string_view one = header.substr(0, end);
    header = end == std::string_view::npos ? std::string_view() : header.substr(end + 1);
    while (!one.empty() && one.front() == ' ') {
      one.remove_prefix(1);
    }
    if (one.size() > name.size() && one.substr(0, name.size()) == name && one[name.size()] == '=') {
      return one.substr(name.size() + 1);
    }
  }
  return {};
}

}  // namespace farrier::web
