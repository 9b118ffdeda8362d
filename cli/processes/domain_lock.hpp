#pragma once

#include "core/result.hpp"

namespace farrier::cli {

/// A DDS domain that no other farrier run uses, held while this object lives. The lock is a loopback port of that
/// domain which DDS does not use: it reaches as far as the domain does, whatever file system the runs see. Domains 1 to
/// 100 keep DDS below the ephemeral ports.
class DomainLock {
 public:
  static Result<DomainLock> acquire();
  ~DomainLock();
  DomainLock(DomainLock&& other) noexcept;
  DomainLock& operator=(DomainLock&&) = delete;

  int domain() const noexcept { return domain_; }

 private:
  DomainLock(int domain, int socket) : domain_(domain), socket_(socket) {}

  int domain_;
  int socket_;
};

}  // namespace farrier::cli
