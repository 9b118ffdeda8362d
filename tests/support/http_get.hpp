#pragma once

#include <cstdint>
#include <string>

namespace farrier::test {

/// A port of this computer on which nothing listens now, and which no connection takes later.
std::uint16_t free_port();

/// Body of what a server of this computer answers; empty when none does.
std::string http_get(std::uint16_t port, const std::string& path);

}  // namespace farrier::test
