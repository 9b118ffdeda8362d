#include "tools/cli/domain_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace farrier::cli {
namespace {

constexpr int kFirstDomain = 1;
constexpr int kLastDomain = 100;

std::string lock_path(int domain) {
  const char* directory = std::getenv("XDG_RUNTIME_DIR");
  return std::string(directory != nullptr ? directory : "/tmp") + "/farrier-domain-" + std::to_string(domain) +
         ".lock";
}

}  // namespace

Result<DomainLock> DomainLock::acquire() {
  for (int domain = kFirstDomain; domain <= kLastDomain; ++domain) {
    const int file = ::open(lock_path(domain).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0) {
      continue;
    }
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) {
      return DomainLock(domain, file);
    }
    ::close(file);
  }
  return Error{"no DDS domain between 1 and 100 is free on this computer: end other runs"};
}

DomainLock::DomainLock(DomainLock&& other) noexcept : domain_(other.domain_), file_(other.file_) { other.file_ = -1; }

DomainLock::~DomainLock() {
  if (file_ >= 0) {
    ::close(file_);
  }
}

}  // namespace farrier::cli
