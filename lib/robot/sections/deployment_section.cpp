#include "robot/sections/deployment_section.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/robot_file.hpp"

namespace farrier::robot {
namespace {

using config::kInitial;
using config::Option;
using config::TextRule;
using config::Visitor;

constexpr std::size_t kLongestInterface = 15;  // IFNAMSIZ - 1
constexpr std::size_t kLongestProcess = 23;    // signals::Name

/// An address that one computer can have: not 0.x, not multicast, not reserved.
bool is_host_address(const std::string& text) {
  in_addr address{};
  if (inet_pton(AF_INET, text.c_str(), &address) != 1) {
    return false;
  }
  const auto first = ntohl(address.s_addr) >> 24;
  return first >= 1 && first <= 223;
}

// As the kernel's dev_valid_name, and nothing that a unit file or a shell would read otherwise.
bool is_interface(const std::string& text) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == '.';
  };
  return !text.empty() && text.size() <= kLongestInterface && text != "." && text != ".." &&
         std::all_of(text.begin(), text.end(), plain);
}

constexpr TextRule kAddress{"IPv4 address of a computer", is_host_address, "give four numbers such as 192.168.10.11"};
constexpr TextRule kInterface{"network interface", is_interface,
                              "give 1 to 15 letters, digits, \"_\", \"-\" or \".\", as `ip link` shows it"};

// A list of whole numbers is read as numbers, which is what the visitor knows.
void declare_cpus(Visitor& v, std::vector<int>& cpus) {
  std::vector<double> numbers(cpus.begin(), cpus.end());
  v.numbers("cpus", numbers, {0, 1023}, "Processors it may run on, whole numbers; empty is all.");
  const bool whole = std::all_of(numbers.begin(), numbers.end(), [](double n) { return n == std::floor(n); });
  v.check(whole, "cpus", "has a number that is not whole: give processors as /proc/cpuinfo counts them");
  cpus.assign(numbers.begin(), numbers.end());
}

}  // namespace

void declare(Visitor& v, DeployedProcess& p) {
  std::array<Option<Program>, kPrograms.size()> programs;
  std::ranges::transform(kPrograms, programs.begin(), [](const ProgramInfo& one) {
    return Option<Program>{one.name, one.program};
  });
  v.here(p.place);
  v.choice<Program>("program", p.program, programs, "What it runs; locomotion plays the gait section.");
  v.names("joints", p.joints, config::Defaults{}, "Joints a joint_node hosts.");
  declare_cpus(v, p.cpus);
  v.integer("memory_max_MB", p.memory_max_MB, {32, 65536}, kInitial,
            "Beyond this the kernel ends it: a leak must not take the host with it.");
}

void declare(Visitor& v, Host& h) {
  v.here(h.place);
  v.text("address", h.address, kAddress, "Address at which the other hosts reach this one.");
  v.text("interface", h.interface, kInterface, "The interface that has it, the only one DDS uses.");
  v.choice<Vendor>("vendor", h.vendor, kDdsVendors, kInitial, "DDS vendor of its processes.");
  v.integer("priority_shift", h.priority_shift, {-39, 15}, kInitial,
            "Added to every SCHED_FIFO priority of its processes (control loops 80, their buses 60, services 40), to "
            "stand above or below what else the host runs.");
  v.groups("processes", h.processes, kLongestProcess, "Processes it runs, by the name the others see.");
}

void declare(Visitor& v, Deployment& d) {
  v.here(d.place);
  v.integer("domain", d.domain, {0, 232}, kInitial,
            "DDS domain of the robot; 0 to 100 keep clear of Linux's own ports.");
  v.integer("session", d.session, {1, 2147483647}, kInitial, "Session of the run, which `farrier request` names.");
  v.choice<ClockKind>("clock", d.clock, kClockKinds, kInitial, "What paces the robot.");
  v.choice<Design>("design", d.design, kDesigns, kInitial,
                   "What the supervisor's gains are for, as --design of farrier trot.");
  v.number("watchdog_s", d.watchdog_s, {0.1, 60}, kInitial,
           "A process whose loop stands still for this long is killed and started anew.");
  v.groups("hosts", d.hosts, kLongestName, "Computers, by name.");
}

}  // namespace farrier::robot
