#pragma once

#include "core/result.hpp"

namespace farrier::cli {

/// A DDS domain no other farrier run of this computer uses, held while this object lives. Domains 1 to 100 keep DDS
/// below the ephemeral ports.
class DomainLock {
 public:
  static Result<DomainLock> acquire();
  ~DomainLock();
  DomainLock(DomainLock&& other) noexcept;
  DomainLock& operator=(DomainLock&&) = delete;

  int domain() const noexcept { return domain_; }

 private:
  DomainLock(int domain, int file) : domain_(domain), file_(file) {}

  int domain_;
  int file_;
};

}  // namespace farrier::cli
