#include "cli/processes/host_clock.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>

namespace farrier::cli {

Result<HostClock> HostClock::create(const std::string& executables, const std::string& path) {
  const std::string library = executables + "/libfarrier_wall_clock.so";
  std::error_code unseen;
  if (!std::filesystem::exists(library, unseen)) {
    return Error{"no " + library + ": install farrier-tools, or build the target 'product'"};
  }
  HostClock clock(library, std::filesystem::absolute(path));
  FARRIER_TRY(clock.set(0));
  return clock;
}

std::vector<std::string> HostClock::environment() const {
  return {"LD_PRELOAD=" + library_, "FARRIER_WALL_CLOCK=" + path_};
}

Result<Done> HostClock::set(int offset_s) const {
  constexpr std::int64_t kSecond_ns = 1'000'000'000;
  const std::int64_t offset_ns = offset_s * kSecond_ns;
  const int file = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
  const bool written = file >= 0 && ::pwrite(file, &offset_ns, sizeof offset_ns, 0) == sizeof offset_ns;
  const int why = errno;
  if (file >= 0) {
    ::close(file);
  }
  return written ? Result<Done>(Done{}) : Error{"cannot write " + path_ + ": " + std::strerror(why)};
}

}  // namespace farrier::cli
