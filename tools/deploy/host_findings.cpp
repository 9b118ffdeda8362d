#include "tools/deploy/host_findings.hpp"

#include <unistd.h>

#include <algorithm>
#include <set>

#include "bus/network.hpp"
#include "runtime/realtime_thread.hpp"
#include "tools/deploy/rendering.hpp"

namespace farrier::deploy {
namespace {

std::string limit_text(std::uint64_t limit) { return limit == ~std::uint64_t{0} ? "unlimited" : std::to_string(limit); }

/// "eth0 (10.0.0.4), lo (127.0.0.1)"
std::string list_of(const std::vector<Interface>& interfaces) {
  std::string text;
  for (const Interface& interface : interfaces) {
    if (!interface.address.empty()) {
      text += (text.empty() ? "" : ", ") + interface.name + " (" + interface.address + ")";
    }
  }
  return text.empty() ? "none with an IPv4 address" : text;
}

Findings address_retry_findings(const HostFacts& facts, const robot::Host& host) {
  const auto interface = std::ranges::find_if(facts.interfaces, [&](const Interface& i) {
    return i.name == host.interface && i.address == host.address;
  });
  if (interface == facts.interfaces.end() || host.address.starts_with("127.") ||
      interface->address_retry_ms <= kAddressRetry_ms) {
    return {};
  }
  return {{"net.ipv4.neigh." + host.interface + ".retrans_time_ms is " + std::to_string(interface->address_retry_ms) +
               ": when its cable comes back, this host is not heard for up to that time",
           "copy the rendered 60-farrier-*.conf to /etc/sysctl.d and run sysctl --system, or sysctl -w net/ipv4/neigh/" +
               host.interface + "/retrans_time_ms=" + std::to_string(kAddressRetry_ms)}};
}

}  // namespace

Findings realtime_findings(const HostFacts& facts, int priority) {
  Findings findings;
  if (!facts.lacks_priority.empty()) {
    findings.push_back({"a process of this user gets no SCHED_FIFO priority " + std::to_string(priority) + ": " +
                            facts.lacks_priority + ", RLIMIT_RTPRIO is " + limit_text(facts.rtprio_limit),
                        "the rendered units allow it by themselves: ask again as root to see what they will get; for "
                        "processes started by hand put '<user> - rtprio " + std::to_string(priority) +
                            "' into /etc/security/limits.d/farrier.conf and log in again; in a container grant "
                            "CAP_SYS_NICE"});
  }
  if (!facts.lacks_locked_memory.empty()) {
    findings.push_back({"a process of this user cannot lock its memory: " + facts.lacks_locked_memory +
                            ", RLIMIT_MEMLOCK is " + limit_text(facts.memlock_limit) + " bytes",
                        "the rendered units allow it by themselves: ask again as root to see what they will get; for "
                        "processes started by hand put '<user> - memlock unlimited' into "
                        "/etc/security/limits.d/farrier.conf and log in again; in a container grant CAP_IPC_LOCK"});
  }
  if (!facts.lacks_awake_processors.empty()) {
    findings.push_back({"a process of this user cannot keep the processors from sleeping: " +
                            facts.lacks_awake_processors + ": loops wake up late",
                        "the rendered farrier-*-awake.service does so: ask again as root to see what it will get; for "
                        "processes started by hand put 'KERNEL==\"cpu_dma_latency\", GROUP=\"<group>\", MODE=\"0660\"' "
                        "into /etc/udev/rules.d/60-farrier.rules and run udevadm control --reload && udevadm trigger"});
  }
  if (!facts.realtime_kernel) {
    findings.push_back({"kernel " + facts.kernel + " is not built with PREEMPT_RT: now and then a loop of 1 kHz wakes "
                        "milliseconds late",
                        "apt install linux-image-rt-amd64, and start that kernel"});
  }
  return findings;
}

Findings buffer_findings(const HostFacts& facts) {
  Findings findings;
  for (const auto& [name, bytes] : {std::pair{"net.core.rmem_max", facts.receive_buffer_max},
                                    std::pair{"net.core.wmem_max", facts.send_buffer_max}}) {
    if (bytes < bus::kSocketBufferBytes) {
      findings.push_back({std::string(name) + " is " + std::to_string(bytes) + " bytes and DDS asks for " +
                              std::to_string(bus::kSocketBufferBytes) + ": bursts of samples may be dropped",
                          "copy the rendered 60-farrier-*.conf to /etc/sysctl.d and run sysctl --system, or " +
                              std::string("sysctl -w ") + name + "=" + std::to_string(bus::kSocketBufferBytes)});
    }
  }
  return findings;
}

Findings address_findings(const HostFacts& facts, const std::string& address, const std::string& interface) {
  const auto named = [&](const Interface& i) { return interface.empty() || i.name == interface; };
  if (std::ranges::none_of(facts.interfaces, named)) {
    return {{"no interface " + interface + " here; there are " + list_of(facts.interfaces),
             "give the interface that has " + address + " (ip -4 address), or bring this one into being"}};
  }
  const auto has_it = std::ranges::find_if(
      facts.interfaces, [&](const Interface& i) { return named(i) && i.address == address; });
  if (has_it == facts.interfaces.end()) {
    return {{(interface.empty() ? "no interface has " : interface + " does not have ") + address + "; there are " +
                 list_of(facts.interfaces),
             interface.empty() ? std::string("give an address of this computer")
                               : "ip address add " + address + "/24 dev " + interface +
                                     ", or give the address it has"}};
  }
  if (!has_it->up) {
    return {{has_it->name + " is down or has no carrier",
             "ip link set " + has_it->name + " up, and look at its cable"}};
  }
  return {};
}

Findings host_findings(const HostFacts& facts, const robot::Deployment& deployment, const robot::Host& host) {
  Findings findings = address_findings(facts, host.address, host.interface);
  for (const auto& [name, process] : host.processes) {
    for (const int cpu : process.cpus) {
      if (std::ranges::find(facts.cpus, cpu) == facts.cpus.end()) {
        findings.push_back({"process " + name + " is for processor " + std::to_string(cpu) + " and this computer has " +
                                std::to_string(facts.cpus.size()),
                            "change deployment.hosts.*.processes." + name + ".cpus to processors of lscpu"});
      }
    }
  }
  append(findings, buffer_findings(facts));
  if (deployment.clock == ClockKind::kRealtime) {
    append(findings, address_retry_findings(facts, host));
    append(findings, realtime_findings(facts, runtime::kControlPriority + host.priority_shift));
  }
  return findings;
}

Findings file_findings(const std::vector<DeployedProcess>& processes, const Places& places,
                       const std::vector<std::string>& differing) {
  Findings findings;
  std::set<std::string> executables;
  for (const DeployedProcess& process : processes) {
    executables.insert(places.executable(process.section.program));
  }
  for (const std::string& executable : executables) {
    if (::access(executable.c_str(), X_OK) != 0) {
      findings.push_back({executable + " is not there or cannot be run",
                          "apt install farrier-runtime, or render and check with --prefix where it is installed"});
    }
  }
  for (const std::string& name : differing) {
    findings.push_back({places.folder + "/" + name + " is not there or not what this robot file asks for",
                        "farrier deploy render it again with --out " + places.folder +
                            ", then systemctl daemon-reload"});
  }
  return findings;
}

}  // namespace farrier::deploy
