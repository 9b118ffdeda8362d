#include "cli/record/guest.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>

#include "bus/settings/peer_address.hpp"
#include "bus_factory/bus_factory.hpp"
#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "process/process.hpp"
#include "runtime/realtime_thread.hpp"
#include "cli/base/command.hpp"
#include "cli/base/help.hpp"

namespace farrier::cli {

std::array<CLI::Option*, 3> declare_network(CLI::App& app, bus::NetworkOptions& network) {
  return {app.add_option("--domain", network.domain, "its DDS domain")
              ->check(CLI::Range(0, 232))
              ->type_name("<n>")
              ->capture_default_str(),
          app.add_option("--address", network.address, "IPv4 address of this computer that DDS uses")
              ->check(bus::address_error)
              ->type_name("<ip>")
              ->capture_default_str(),
          app.add_option("--peers", network.peers, "computers the robot runs on, by IPv4 address or name")
              ->delimiter(',')
              ->check(bus::peer_error)
              ->type_name("<ip>,...")
              ->default_str("127.0.0.1")};
}

void declare_vendor(CLI::App& app, std::string& vendor) {
  add_name(app, "--dds", vendor, kDdsVendors, "vendor of this process")->capture_default_str();
}

void declare_guest(CLI::App& app, GuestOptions& options) {
  declare_network(app, options.network);
  app.add_option("--robot", options.robot_path, "robot file")->type_name("<file>")->default_str("hyq.yaml, as shipped");
  declare_vendor(app, options.vendor);
  app.add_option("--security", options.security, "folder of keys and permissions, of a robot that runs with --security")
      ->type_name("<dir>");
}

Result<std::unique_ptr<bus::Bus>, Refused> join_as_guest(const GuestOptions& options, bus::Role role) {
  const bus::Vendor vendor = bus::parse_vendor(options.vendor).value();
  if (role == bus::Role::kMonitor) {
    runtime::give_way();  // an observer must not delay the robot
  }
  bus::NetworkOptions network = options.network;
  network.unhurried = network.unhurried || role == bus::Role::kMonitor;
  if (auto secured = process::secure(network, options.security, role, vendor); !secured) {
    return Refused{secured.error().message, kBadInput};
  }
  auto bus = bus_factory::create_bus(vendor, network);
  if (!bus) {
    return Refused{bus.error().message, kFailed};
  }
  return std::move(bus).value();
}

void nap(bus::Bus& bus, SteadyTime until) {
  using namespace std::chrono_literals;
  while (!participant::stop_requested() && participant::steady_now() < until) {
    const Nanoseconds left = until - participant::steady_now();
    bus.wait_for_arrivals(~std::uint64_t{0}, std::min<Nanoseconds>(left, 50ms));
  }
}

}  // namespace farrier::cli
