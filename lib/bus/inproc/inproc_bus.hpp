#pragma once

// The bus within one process, with the QoS semantics of DDS: several "processes" are several buses of one domain.
// It is the oracle of the conformance suite and what the lab and the scenario tests run on.

#include <cstdint>
#include <functional>
#include <memory>

#include "bus/bus.hpp"
#include "core/time.hpp"

namespace farrier::bus {

struct InprocState;

/// State that the buses of one in-process network share. Thread-safe. Deadlines and leases are judged by `clock`
/// whenever a sample is written or a reader is polled, so a simulated clock decides them. The clock is called with a
/// lock held and must not use the domain.
class InprocDomain {
 public:
  explicit InprocDomain(std::function<SteadyTime()> clock);
  ~InprocDomain();
  InprocDomain(const InprocDomain&) = delete;
  InprocDomain& operator=(const InprocDomain&) = delete;

  /// Samples that a newer one of their key replaced in a reader's history before they were taken. They are not lost:
  /// KEEP_LAST asks for it.
  std::uint64_t overwritten() const noexcept;

  /// For create_inproc_bus.
  InprocState& state() noexcept { return *state_; }

 private:
  std::unique_ptr<InprocState> state_;
};

/// One process's membership in an in-process domain.
///
/// Steady state neither allocates nor waits: rings of history_depth samples are allocated per (reader, key), and per
/// (transient-local writer, key), by the first sample of the key. Samples of one reader are taken in the order in
/// which they were written, across keys too.
std::unique_ptr<Bus> create_inproc_bus(std::shared_ptr<InprocDomain> domain);

}  // namespace farrier::bus
