// farrier doctor: finds why no data comes or real time is refused, and the remedy.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "bus_factory/bus_factory.hpp"
#include "runtime/realtime_thread.hpp"
#include "cli/base/command.hpp"
#include "cli/deploy/findings.hpp"
#include "cli/record/guest.hpp"
#include "cli/base/help.hpp"
#include "cli/base/installation.hpp"
#include "tools/deploy/bus_findings.hpp"
#include "tools/deploy/domain_ports.hpp"
#include "tools/deploy/host_findings.hpp"
#include "tools/deploy/surroundings.hpp"

namespace farrier::cli {
namespace {

struct DoctorOptions {
  std::string robot_path = shipped_robot("hyq.yaml");
  std::string host;
  double look_s = 3.0;
  bool realtime = false;
  std::string shared_memory = "/dev/shm";
  bus::NetworkOptions network;
};

/// Findings about this computer alone.
deploy::Findings local_findings(const DoctorOptions& o, const std::string& interface) {
  const deploy::HostFacts facts = deploy::this_host(runtime::kControlPriority);
  deploy::Findings findings = deploy::address_findings(facts, o.network.address, interface);
  deploy::append(findings, deploy::multicast_findings(facts, o.network.address));
  deploy::append(findings, deploy::port_findings(o.network, deploy::bound_udp_ports(), deploy::ephemeral_ports()));
  deploy::append(findings, deploy::buffer_findings(facts));
  deploy::append(findings, deploy::leftover_findings(o.shared_memory));
  deploy::append(findings, deploy::environment_findings(o.network));
  if (o.realtime) {
    deploy::append(findings, deploy::realtime_findings(facts, runtime::kControlPriority));
  }
  return findings;
}

int run_doctor(DoctorOptions o) {
  const auto robot = robot::load_robot(o.robot_path);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  std::string interface;
  if (!o.host.empty()) {
    const auto& deployment = robot.value().file.deployment;
    const robot::Host* const host = deployment ? config::find(deployment->hosts, o.host) : nullptr;
    if (host == nullptr) {
      return refuse("doctor", "--host: " + o.robot_path + " has no deployment with a host '" + o.host + "'");
    }
    interface = host->interface;
    o.realtime = o.realtime || deployment->clock == ClockKind::kRealtime;
    o.network.domain = deployment->domain;
    o.network.address = host->address;
    o.network.peers.clear();
    for (const auto& [name, other] : deployment->hosts) {
      o.network.peers.push_back(other.address);
    }
  }
  deploy::Findings findings = local_findings(o, interface);
  const auto found = bus_factory::discover(
      o.network, std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(o.look_s)));
  if (!found) {
    findings.push_back({found.error().message, "see what was found before this; DDS cannot be looked into until then"});
  } else {
    deploy::append(findings, deploy::bus_findings(found.value(), robot.value().name, o.network));
    if (found.value().participants.empty()) {
      deploy::append(findings, deploy::other_domain_findings(o.network, deploy::bound_udp_ports()));
    }
    std::printf("domain %d from %s: %zu processes, %zu writers and readers\n", o.network.domain,
                o.network.address.c_str(), found.value().participants.size(), found.value().endpoints.size());
  }
  return print_findings(findings, robot.value().name);
}

}  // namespace

std::function<int()> declare_doctor(CLI::App& app) {
  auto o = std::make_shared<DoctorOptions>();
  app.add_option("--robot", o->robot_path, "robot file")->type_name("<file>")->default_str("hyq.yaml, as shipped");
  CLI::Option* const host =
      app.add_option("--host", o->host, "look from this host of the deployment, which has domain, address and peers")
          ->type_name("<name>");
  for (CLI::Option* const network : declare_network(app, o->network)) {
    network->excludes(host);
  }
  app.add_option("--look", o->look_s, "how long to look for processes")
      ->check(between(0.1, 60.0))
      ->type_name("<s>")
      ->capture_default_str();
  app.add_flag("--realtime", o->realtime, "look for what the real-time clock needs, too")->type_name("");
  app.add_option("--shared-memory", o->shared_memory, "where Fast DDS keeps its segments")
      ->type_name("<dir>")
      ->capture_default_str();
  return [o] { return run_doctor(*o); };
}

}  // namespace farrier::cli
