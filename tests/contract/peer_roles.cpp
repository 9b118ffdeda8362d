#include <net/if.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <memory>
#include <set>
#include <sstream>
#include <thread>

#include "bus_factory/bus_factory.hpp"
#include "buses.hpp"
#include "peer.hpp"
#include "security/credentials.hpp"

namespace farrier::contract {
namespace {

using namespace std::chrono_literals;

constexpr const char* kModeWriter = "--mode-writer";
constexpr const char* kEventReader = "--event-reader";
constexpr const char* kGreeter = "--greeter";
constexpr const char* kIsolatedGreeters = "--isolated-greeters";
constexpr const char* kIsolatedGatherer = "--isolated-gatherer";

/// True once the standard input is closed, which asks this process to leave.
bool dismissed(int timeout_ms) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, timeout_ms) > 0;
}

std::unique_ptr<bus::Bus> own_bus(const std::string& vendor, const std::string& domain) {
  return make_bus(bus::parse_vendor(vendor).value(), std::stoi(domain), nullptr);
}

int write_modes(bus::Bus& bus, const std::string& robot, int strength) {
  auto writer = bus::Publisher<signals::SystemMode>::create(
      bus, {bus::TopicId::kSystemMode, authority(), {robot}, strength});
  signals::SystemMode mode;
  mode.epoch = static_cast<std::uint32_t>(strength);
  while (!dismissed(2)) {
    ++mode.effective_tick;
    writer.value().publish(mode);
  }
  return 0;
}

int read_events(bus::Bus& bus, const std::string& robot) {
  auto reader = bus::Subscription<signals::SystemEvent>::create(
      bus, {bus::TopicId::kSystemEvent, {bus::Reliability::kReliable}, {robot}});
  while (!dismissed(10)) {
    reader.value().drain([](const signals::SystemEvent&) {});
  }
  return 0;
}

int greet(bus::Bus& bus, int index, std::size_t count, SteadyTime start) {
  const bus::Qos qos = bus::qos_for(bus::spec(bus::TopicId::kSystemHello), bus::ClockKind::kRealtime);
  const bus::EndpointSpec endpoint{bus::TopicId::kSystemHello, qos, {"robot"}};
  auto reader = bus::Subscription<signals::SystemHello>::create(bus, endpoint);
  auto writer = bus::Publisher<signals::SystemHello>::create(bus, endpoint);
  signals::SystemHello hello;
  hello.participant = static_cast<std::uint16_t>(index);
  writer.value().publish(hello);
  std::set<int> heard;
  while (heard.size() < count && !dismissed(0)) {
    const std::uint64_t seen = bus.arrivals();
    reader.value().drain([&](const signals::SystemHello& other) { heard.insert(other.participant); });
    bus.wait_for_arrivals(seen + 1, 20ms);
  }
  std::cout << to_string(bus.vendor()) << ' ' << (std::chrono::steady_clock::now() - start) / 1ms << std::endl;
  while (!dismissed(-1)) {
  }
  return 0;
}

/// Empty, or why this process could not get a network of its own with nothing but a loopback device.
std::string isolate_network() {
  if (unshare(CLONE_NEWNET) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) {
    return std::string("no network namespace: ") + std::strerror(errno);
  }
  const int probe = socket(AF_INET, SOCK_DGRAM, 0);
  ifreq request{};
  std::strcpy(request.ifr_name, "lo");
  ioctl(probe, SIOCGIFFLAGS, &request);
  request.ifr_flags = static_cast<short>((request.ifr_flags | IFF_UP) & ~IFF_MULTICAST);
  const int raised = ioctl(probe, SIOCSIFFLAGS, &request);
  close(probe);
  return raised == 0 ? "" : std::string("loopback cannot be raised: ") + std::strerror(errno);
}

int greet_isolated(int count) {
  const std::string reason = isolate_network();
  if (!reason.empty()) {
    std::cout << "skip " << reason << std::endl;
    return 0;
  }
  std::vector<std::unique_ptr<Peer>> greeters;
  for (int i = 0; i < count; ++i) {
    const bool fast = i % 2 == 1 && available(bus::Vendor::kFast);
    greeters.push_back(
        std::make_unique<Peer>(greeter(fast ? bus::Vendor::kFast : bus::Vendor::kCyclone, own_domain(), i, count)));
  }
  for (const auto& peer : greeters) {
    std::cout << peer->read_line() << std::endl;
  }
  return 0;
}

/// Datagrams that this process's network has sent.
long datagrams_sent() {
  std::ifstream counters("/proc/self/net/snmp");
  for (std::string names, values; std::getline(counters, names) && std::getline(counters, values);) {
    std::istringstream name_words(names), value_words(values);
    std::string name, value;
    while (name_words >> name && value_words >> value) {
      if (names.rfind("Udp:", 0) == 0 && name == "OutDatagrams") {
        return std::stol(value);
      }
    }
  }
  return -1;
}

/// Writes the sensors of a leg's three joints together, again and again.
int gather_isolated(bus::Vendor writes, bus::Vendor reads, const std::string& partition, const std::string& keys) {
  if (const std::string reason = isolate_network(); !reason.empty()) {
    std::cout << "skip " << reason << std::endl;
    return 0;
  }
  const auto join = [&](bus::Role role, bus::Vendor vendor) {
    bus::NetworkOptions options;
    options.domain = own_domain();
    if (!keys.empty()) {
      options.security = security::files_of(keys, role, vendor);
    }
    auto joined = bus_factory::create_bus(vendor, options);
    FARRIER_ENSURE(joined.ok(), joined.error().message.c_str());
    return std::move(joined).value();
  };
  const std::unique_ptr<bus::Bus> writing = join(bus::Role::kSimBridge, writes);
  const std::unique_ptr<bus::Bus> reading = join(bus::Role::kJointNode, reads);
  const bus::Qos qos = bus::qos_for(bus::spec(bus::TopicId::kJointSensors), bus::ClockKind::kRealtime);
  const bus::EndpointSpec endpoint{bus::TopicId::kJointSensors, qos, {partition}};
  auto writer = bus::Publisher<signals::JointSensors>::create(*writing, endpoint);
  auto reader = bus::Subscription<signals::JointSensors>::create(*reading, endpoint);
  std::size_t heard = 0;
  // As long as nobody hears, endpoints have not found each other; what that takes is not counted.
  const auto write_a_tick = [&](Tick tick) {
    const std::uint64_t seen = reading->arrivals();
    for (std::uint16_t joint = 0; joint < kGatheredJoints; ++joint) {
      signals::JointSensors sensors;
      sensors.joint = joint;
      sensors.tick = tick;
      writer.value().queue(sensors);
    }
    writer.value().flush();
    reading->wait_for_arrivals(seen + kGatheredJoints, 20ms);
    return reader.value().drain([](const signals::JointSensors&) {});
  };
  for (const SteadyTime end = std::chrono::steady_clock::now() + 30s;
       write_a_tick(0) < kGatheredJoints && std::chrono::steady_clock::now() < end;) {
  }
  std::this_thread::sleep_for(500ms);
  const long before = datagrams_sent();
  for (int tick = 1; tick <= kGatheredTicks; ++tick) {
    heard += write_a_tick(tick);
  }
  std::cout << heard << ' ' << datagrams_sent() - before << std::endl;
  return 0;
}

}  // namespace

bus::Qos authority() {
  return bus::qos_for(bus::spec(bus::TopicId::kSystemMode), bus::ClockKind::kRealtime);
}

std::vector<std::string> mode_writer(bus::Vendor vendor, int domain, const std::string& robot, int strength) {
  return {kModeWriter, to_string(vendor), std::to_string(domain), robot, std::to_string(strength)};
}

std::vector<std::string> event_reader(bus::Vendor vendor, int domain, const std::string& robot) {
  return {kEventReader, to_string(vendor), std::to_string(domain), robot};
}

std::vector<std::string> greeter(bus::Vendor vendor, int domain, int index, int count) {
  return {kGreeter, to_string(vendor), std::to_string(domain), std::to_string(index), std::to_string(count)};
}

std::vector<std::string> isolated_greeters(int count) { return {kIsolatedGreeters, std::to_string(count)}; }

std::vector<std::string> isolated_gatherer(bus::Vendor writer, bus::Vendor reader, const std::string& partition,
                                           const std::string& keys) {
  return {kIsolatedGatherer, to_string(writer), to_string(reader), partition, keys};
}

int run_role(const std::vector<std::string>& arguments) {
  const SteadyTime start = std::chrono::steady_clock::now();
  const std::string role = arguments.empty() ? "" : arguments[0];
  if (role == kModeWriter) {
    return write_modes(*own_bus(arguments.at(1), arguments.at(2)), arguments.at(3), std::stoi(arguments.at(4)));
  }
  if (role == kEventReader) {
    return read_events(*own_bus(arguments.at(1), arguments.at(2)), arguments.at(3));
  }
  if (role == kGreeter) {
    return greet(*own_bus(arguments.at(1), arguments.at(2)), std::stoi(arguments.at(3)),
                 std::stoul(arguments.at(4)), start);
  }
  if (role == kIsolatedGreeters) {
    return greet_isolated(std::stoi(arguments.at(1)));
  }
  if (role == kIsolatedGatherer) {
    return gather_isolated(bus::parse_vendor(arguments.at(1)).value(), bus::parse_vendor(arguments.at(2)).value(),
                           arguments.at(3), arguments.at(4));
  }
  return -1;
}

}  // namespace farrier::contract
