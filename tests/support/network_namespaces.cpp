#include "tests/support/network_namespaces.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <thread>

namespace farrier::test {
namespace {

constexpr const char* kIp[] = {"/usr/sbin/ip", "/sbin/ip", "/usr/bin/ip", "/bin/ip"};

const char* ip_command() {
  for (const char* path : kIp) {
    if (::access(path, X_OK) == 0) {
      return path;
    }
  }
  return nullptr;
}

Descriptor own_namespace() { return Descriptor(::open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC)); }

/// A new one; without a descriptor, and with errno, where it is not permitted.
Descriptor make_namespace() {
  Descriptor made;
  int problem = 0;
  std::thread([&] {
    if (::unshare(CLONE_NEWNET) == 0) {
      made = own_namespace();
    }
    problem = errno;
  }).join();
  errno = problem;
  return made;
}

/// The bridge's end of a host's cable.
std::string port_of(const std::string& host) { return "to_" + host; }

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) {
    ::close(number_);
  }
}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

std::string NetworkNamespaces::refusal() {
  if (ip_command() == nullptr) {
    return "network namespaces are joined by `ip`, which is not here: install iproute2";
  }
  if (::geteuid() != 0) {
    return "network namespaces are made by root: run this test as root";
  }
  if (make_namespace().number() < 0) {
    return std::string("this computer gives root no network namespace: ") + std::strerror(errno);
  }
  return {};
}

NetworkNamespaces::NetworkNamespaces(const std::vector<Host>& hosts) {
  namespaces_[kSwitch] = make_namespace();
  ip(kSwitch, "link set lo up\nlink add bridge type bridge\nlink set bridge up\n");
  {
    const Visit visit(*this, kSwitch);
    switch_socket_ = Descriptor(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  }
  for (const Host& host : hosts) {
    Descriptor& made = namespaces_[host.name] = make_namespace();
    const std::string port = port_of(host.name);
    const std::string place = "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(made.number());
    ip(kSwitch, "link add " + port + " type veth peer name " + host.interface + " netns " + place + "\nlink set " + port +
                    " master bridge\nlink set " + port + " up\n");
    ip(host.name, "link set lo up\naddr add " + host.address + "/24 dev " + host.interface + "\nlink set " +
                      host.interface + " multicast off\nlink set " + host.interface + " up\n");
  }
  for (const Host& host : hosts) {
    await_carrier(kSwitch, port_of(host.name));
    await_carrier(host.name, host.interface);
  }
}

std::function<void()> NetworkNamespaces::at(const std::string& host) const {
  return [number = descriptor_of(host)] {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::setns(number, CLONE_NEWNET) != 0) {
      ::_exit(127);
    }
  };
}

void NetworkNamespaces::set(const std::string& host, const std::string& name, const std::string& value) const {
  const Visit visit(*this, host);
  std::ofstream file("/proc/sys/" + name);
  file << value << std::flush;
  EXPECT_TRUE(file.good()) << name;
}

std::pair<std::string, std::string> NetworkNamespaces::open_cable(const std::string& host) {
  const std::string port = port_of(host);
  const std::string inner = "via_" + host;
  const std::string outer = "as_" + host;
  ip(kSwitch, "link set " + port + " nomaster\nlink add " + inner + " type veth peer name " + outer + "\nlink set " + outer +
                  " master bridge\nlink set " + outer + " up\nlink set " + inner + " up\n");
  await_carrier(kSwitch, outer);
  await_carrier(kSwitch, inner);
  return {port, inner};
}

int NetworkNamespaces::descriptor_of(const std::string& host) const {
  const auto found = namespaces_.find(host);
  EXPECT_NE(found, namespaces_.end()) << host;
  return found == namespaces_.end() ? -1 : found->second.number();
}

std::string NetworkNamespaces::ip(const std::string& host, const std::string& batch) const {
  int ends[2], printed[2];
  EXPECT_EQ(::pipe2(ends, O_CLOEXEC), 0);
  EXPECT_EQ(::pipe2(printed, O_CLOEXEC), 0);
  const auto enter = at(host);
  const pid_t pid = ::fork();
  if (pid == 0) {
    ::dup2(ends[0], STDIN_FILENO);
    ::dup2(printed[1], STDOUT_FILENO);
    enter();
    ::execl(ip_command(), "ip", "-batch", "-", nullptr);
    ::_exit(127);
  }
  EXPECT_EQ(::write(ends[1], batch.data(), batch.size()), static_cast<ssize_t>(batch.size()));
  ::close(ends[0]);
  ::close(ends[1]);
  ::close(printed[1]);
  std::string text;
  char part[4096];
  for (ssize_t length; (length = ::read(printed[0], part, sizeof part)) > 0;) {
    text.append(part, static_cast<std::size_t>(length));
  }
  ::close(printed[0]);
  int status = -1;
  ::waitpid(pid, &status, 0);
  EXPECT_EQ(status, 0) << "ip refuses for " << host << ":\n" << batch;
  return text;
}

void NetworkNamespaces::await_carrier(const std::string& host, const std::string& interface) const {
  const auto latest = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (ip(host, "link show dev " + interface + " up\n").find("state UP") == std::string::npos) {
    if (std::chrono::steady_clock::now() > latest) {
      ADD_FAILURE() << host << ": " << interface << " has no carrier";
      return;
    }
  }
  // Listeners for the carrier are notified under the lock of interfaces, which this call waits for.
  ip(host, "link set " + interface + " up\n");
}

void NetworkNamespaces::set_up(const std::string& host, bool up) const {
  ifreq request{};
  std::strncpy(request.ifr_name, port_of(host).c_str(), IFNAMSIZ - 1);
  ASSERT_EQ(::ioctl(switch_socket_.number(), SIOCGIFFLAGS, &request), 0) << std::strerror(errno);
  const int flags = up ? request.ifr_flags | IFF_UP : request.ifr_flags & ~IFF_UP;
  request.ifr_flags = static_cast<short>(flags);
  ASSERT_EQ(::ioctl(switch_socket_.number(), SIOCSIFFLAGS, &request), 0) << std::strerror(errno);
}

NetworkNamespaces::Visit::Visit(const NetworkNamespaces& network, const std::string& host) : home_(own_namespace()) {
  EXPECT_EQ(::setns(network.descriptor_of(host), CLONE_NEWNET), 0) << host << ": " << std::strerror(errno);
}

NetworkNamespaces::Visit::~Visit() { ::setns(home_.number(), CLONE_NEWNET); }

}  // namespace farrier::test
