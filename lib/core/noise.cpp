#include "core/noise.hpp"

#include <cmath>

#include "core/portable_math.hpp"

namespace farrier {
namespace {

// Finaliser of SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t mix(std::uint64_t z) noexcept {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

std::uint64_t draw(std::uint64_t key, std::uint64_t counter) noexcept {
  return mix(key + 0x9e3779b97f4a7c15ull * (counter + 1));
}

double to_unit(std::uint64_t bits) noexcept { return static_cast<double>(bits >> 11) * 0x1.0p-53; }

}  // namespace

NoiseStream::NoiseStream(std::uint64_t seed, std::string_view name, std::string_view channel) noexcept
    : key_(mix(mix(seed ^ stable_hash(name)) ^ stable_hash(channel))) {}

double NoiseStream::uniform(Tick tick) const noexcept {
  return to_unit(draw(key_, 2 * static_cast<std::uint64_t>(tick)));
}

double NoiseStream::normal(Tick tick) const noexcept {
  const auto counter = 2 * static_cast<std::uint64_t>(tick);
  const double radius = std::sqrt(-2.0 * portable::log(1.0 - to_unit(draw(key_, counter))));
  return radius * portable::cos_of_turns(to_unit(draw(key_, counter + 1)));
}

}  // namespace farrier
