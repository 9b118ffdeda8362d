#pragma once

#include <cstddef>

namespace farrier::test {

/// Counts operator new of the calling thread while it lives. Link allocation_guard.cpp, which replaces it.
class AllocationGuard {
 public:
  AllocationGuard() noexcept;

  /// Allocations of this thread since construction.
  std::size_t allocations() const noexcept;

 private:
  std::size_t at_start_;
};

}  // namespace farrier::test
