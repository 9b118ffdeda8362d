#pragma once

#include <cstdint>
#include <string_view>

#include "core/time.hpp"

namespace farrier {

/// Stable 64-bit hash of a name (FNV-1a; Fowler, Noll, Vo 1991), the same on every machine.
constexpr std::uint64_t stable_hash(std::string_view text) noexcept {
  std::uint64_t hash = 0xcbf29ce484222325ull;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  }
  return hash;
}

/// White noise addressed by tick: the same (seed, name, channel, tick) gives the same number whatever was drawn
/// before it, so traces do not depend on the order in which joints are computed.
class NoiseStream {
 public:
  NoiseStream(std::uint64_t seed, std::string_view name, std::string_view channel) noexcept;

  /// Uniform in [0, 1).
  double uniform(Tick tick) const noexcept;

  /// Standard normal (Box and Muller 1958).
  double normal(Tick tick) const noexcept;

 private:
  std::uint64_t key_;
};

}  // namespace farrier
