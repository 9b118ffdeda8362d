#include "tools/deploy/host_facts.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <sstream>

#include "runtime/awake_processors.hpp"
#include "runtime/realtime_thread.hpp"

namespace farrier::deploy {
namespace {

std::string first_line(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

std::uint64_t number_in(const std::string& path) { return std::strtoull(first_line(path).c_str(), nullptr, 10); }

std::vector<Interface> interfaces() {
  ifaddrs* list = nullptr;
  if (::getifaddrs(&list) != 0) {
    return {};
  }
  std::vector<Interface> found;
  for (const ifaddrs* entry = list; entry != nullptr; entry = entry->ifa_next) {
    // Every interface comes once as a packet device and once per address.
    const bool ipv4 = entry->ifa_addr != nullptr && entry->ifa_addr->sa_family == AF_INET;
    if (!ipv4 && (entry->ifa_addr == nullptr || entry->ifa_addr->sa_family != AF_PACKET)) {
      continue;
    }
    Interface interface{.name = entry->ifa_name,
                        .address = {},
                        .up = (entry->ifa_flags & IFF_UP) != 0 && (entry->ifa_flags & IFF_RUNNING) != 0,
                        .multicast = (entry->ifa_flags & IFF_MULTICAST) != 0,
                        .address_retry_ms = number_in("/proc/sys/net/ipv4/neigh/" + std::string(entry->ifa_name) +
                                                      "/retrans_time_ms")};
    if (ipv4) {
      char text[INET_ADDRSTRLEN] = {};
      ::inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(entry->ifa_addr)->sin_addr, text, sizeof text);
      interface.address = text;
    }
    found.push_back(interface);
  }
  ::freeifaddrs(list);
  return found;
}

/// Runs `attempt` in a process that ends with it, and returns its text.
std::string tried_apart(const std::function<std::string()>& attempt) {
  int ends[2];
  if (::pipe(ends) != 0) {
    return "cannot be tried";
  }
  const pid_t pid = ::fork();
  if (pid == 0) {
    const std::string said = attempt();
    const ssize_t written = ::write(ends[1], said.data(), said.size());
    ::_exit(written == static_cast<ssize_t>(said.size()) ? 0 : 1);
  }
  ::close(ends[1]);
  char said[256];
  const ssize_t length = pid > 0 ? ::read(ends[0], said, sizeof said) : 0;
  ::close(ends[0]);
  int status = -1;
  if (pid > 0) {
    ::waitpid(pid, &status, 0);
  }
  return status == 0 ? std::string(said, said + (length > 0 ? length : 0)) : "cannot be tried";
}

std::uint64_t limit(int resource) {
  rlimit value{};
  return ::getrlimit(static_cast<__rlimit_resource_t>(resource), &value) == 0 ? value.rlim_cur : 0;
}

}  // namespace

std::vector<int> parse_cpu_list(const std::string& text) {
  std::vector<int> cpus;
  std::istringstream ranges(text);
  for (std::string range; std::getline(ranges, range, ',');) {
    const std::size_t dash = range.find('-');
    const int first = std::atoi(range.c_str());
    const int last = dash == std::string::npos ? first : std::atoi(range.c_str() + dash + 1);
    for (int cpu = first; cpu <= last && !range.empty(); ++cpu) {
      cpus.push_back(cpu);
    }
  }
  return cpus;
}

HostFacts this_host(int priority) {
  HostFacts facts;
  utsname system{};
  ::uname(&system);
  facts.name = system.nodename;
  facts.kernel = system.release;
  // Kernels built with PREEMPT_RT say so in /sys or, in older patches, only in their version.
  facts.realtime_kernel = first_line("/sys/kernel/realtime") == "1" ||
                          std::string(system.version).find("PREEMPT_RT") != std::string::npos ||
                          std::string(system.version).find("PREEMPT RT") != std::string::npos;
  facts.interfaces = interfaces();
  facts.cpus = parse_cpu_list(first_line("/sys/devices/system/cpu/online"));
  facts.receive_buffer_max = number_in("/proc/sys/net/core/rmem_max");
  facts.send_buffer_max = number_in("/proc/sys/net/core/wmem_max");
  facts.rtprio_limit = limit(RLIMIT_RTPRIO);
  facts.memlock_limit = limit(RLIMIT_MEMLOCK);
  facts.lacks_priority = tried_apart([priority] { return runtime::set_priority(priority); });
  facts.lacks_locked_memory = tried_apart([] { return runtime::lock_memory(); });
  facts.lacks_awake_processors = tried_apart([] { return runtime::AwakeProcessors().lacking(); });
  return facts;
}

}  // namespace farrier::deploy
