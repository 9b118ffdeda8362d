#pragma once

// Reads by each vendor of the bytes that signals::to_cdr writes, and its own bytes. Two sources, because idlc and
// fastddsgen name their headers alike.

#include <cstdint>
#include <span>
#include <vector>

#include "signals/fields.hpp"

namespace farrier::contract {

#define FARRIER_VENDORS(Signal, file)                                                              \
  bool cyclone_reads(std::span<const std::uint8_t> bytes, signals::Signal& signal);                \
  bool fast_reads(std::span<const std::uint8_t> bytes, signals::Signal& signal);                   \
  std::vector<std::uint8_t> fast_writes(const signals::Signal& signal);
FARRIER_SIGNALS(FARRIER_VENDORS)
#undef FARRIER_VENDORS

}  // namespace farrier::contract
