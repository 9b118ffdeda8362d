// farrier monitor: a running robot at a glance. Every display gets its frames: the terminal's table, Prometheus, a
// page.

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>

#include "monitor/watch.hpp"
#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "cli/base/command.hpp"
#include "cli/record/guest.hpp"
#include "cli/monitor/monitor_web.hpp"
#include "tools/foxglove/foxglove_display.hpp"
#include "tools/monitor/plain_text.hpp"
#include "tools/monitor/prometheus_exposer.hpp"
#include "tools/monitor/terminal.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

constexpr auto kNextLook = 50ms;
constexpr auto kSilenceWorthSaying = 5s;
constexpr double kWholeLook_s = 1.2;  // errors and rates are over a second

struct MonitorOptions {
  std::string prometheus;
  std::string foxglove;
  bool once = false;
  WebOptions web;
  GuestOptions guest;
};

using Displays = std::vector<std::unique_ptr<display::Display>>;

/// Displays for other programs. One of them is `foxglove`, or it is null.
struct Servers {
  Displays displays;
  foxglove::FoxgloveDisplay* foxglove = nullptr;
};

std::string nothing_comes(const MonitorOptions& o) {
  const std::string domain = std::to_string(o.guest.network.domain);
  return "nothing comes in domain " + domain + "; why: farrier doctor --domain " + domain;
}

/// Servers for other programs, opened before anything moves: an address that cannot be had is a mistake in the options.
Result<Servers> open_servers(const MonitorOptions& o, const robot::Robot& robot) {
  Servers servers;
  if (!o.prometheus.empty()) {
    const auto address = display::parse_listen_address(o.prometheus);
    if (!address) {
      return Error{"--prometheus: " + address.error().message};
    }
    auto server = display::expose_to_prometheus(address.value(), robot);
    if (!server) {
      return Error{"--prometheus: " + server.error().message};
    }
    std::fprintf(stderr, "farrier monitor: metrics at http://%s/metrics\n", address.value().text().c_str());
    servers.displays.push_back(std::move(server).value());
  }
  if (!o.web.address.empty()) {
    servers.displays.push_back(FARRIER_TRY(open_web(o.web, robot)));
  }
  if (!o.foxglove.empty()) {
    const auto address = display::parse_listen_address(o.foxglove);
    if (!address) {
      return Error{"--foxglove: " + address.error().message};
    }
    auto server = foxglove::FoxgloveDisplay::create(address.value(), robot);
    if (!server) {
      return Error{"--foxglove: " + server.error().message};
    }
    servers.foxglove = server.value().get();
    std::fprintf(stderr, "farrier monitor: Foxglove at %s\n", servers.foxglove->url().c_str());
    servers.displays.push_back(std::move(server).value());
  }
  return servers;
}

/// Opens the table: on a terminal with keys, elsewhere as text unless only a server is asked for. Returns true if it
/// has the screen, on which nothing else may write.
Result<bool> open_table(Displays& displays, const robot::Robot& robot) {
  if (::isatty(STDIN_FILENO) == 1 && ::isatty(STDOUT_FILENO) == 1) {
    displays.push_back(FARRIER_TRY(display::Terminal::create(robot)));
    return true;
  }
  if (displays.empty()) {
    displays.push_back(std::make_unique<display::PlainText>(robot));
  }
  return false;
}

/// Waits until the next look is due, while viewers of Foxglove are served.
void wait_for_look(bus::Bus& bus, foxglove::FoxgloveDisplay* foxglove) {
  const SteadyTime look = participant::steady_now() + kNextLook;
  if (foxglove == nullptr) {
    nap(bus, look);
    return;
  }
  for (SteadyTime now = participant::steady_now(); now < look && !participant::stop_requested();
       now = participant::steady_now()) {
    nap(bus, std::min<SteadyTime>(look, now + foxglove::FoxgloveDisplay::kStep));
    foxglove->step();
  }
}

/// Shows frames until the user asks for the end. `quiet`: prints nothing itself.
int show(bus::Bus& bus, monitor::Watch& watch, const Servers& servers, const MonitorOptions& o, bool quiet) {
  const Displays& displays = servers.displays;
  SteadyTime complaint = participant::steady_now() + kSilenceWorthSaying;
  while (!participant::stop_requested()) {
    wait_for_look(bus, servers.foxglove);
    const monitor::Frame frame = watch.look();
    for (const auto& display : displays) {
      display->show(frame);
      if (display->ended()) {
        return kPassed;
      }
    }
    if (const SteadyTime now = participant::steady_now(); !quiet && std::isinf(frame.age_s) && now > complaint) {
      complaint = SteadyTime::max();
      std::fprintf(stderr, "farrier monitor: %s\n", nothing_comes(o).c_str());
    }
  }
  return participant::stop_status();
}

int show_once(bus::Bus& bus, monitor::Watch& watch, const robot::Robot& robot, const MonitorOptions& o) {
  const SteadyTime last = participant::steady_now() + kSilenceWorthSaying;
  display::RecentEvents events;
  monitor::Frame frame;
  bool whole = false;
  while (!whole && !participant::stop_requested() && participant::steady_now() < last) {
    nap(bus, participant::steady_now() + kNextLook);
    frame = watch.look();
    events.take(frame);
    whole = frame.time_s > kWholeLook_s &&
            std::ranges::all_of(frame.joints, [](const monitor::JointFrame& joint) { return joint.rate_Hz > 0.0; });
  }
  if (participant::stop_requested()) {
    return participant::stop_status();
  }
  if (frame.joints.empty() || std::isinf(frame.age_s)) {
    return fail("monitor", nothing_comes(o));
  }
  return display::print_table(frame, robot, events.all()) ? kPassed : kFailed;
}

int run_monitor(const MonitorOptions& o) {
  if (!o.web.recording.empty()) {
    return show_recording(o.web);
  }
  participant::install_signal_handlers();
  const auto robot = robot::load_robot(o.guest.robot_path);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  auto servers = open_servers(o, robot.value());
  if (!servers) {
    return refuse("monitor", servers.error().message);
  }
  auto bus = join_as_guest(o.guest, bus::Role::kMonitor);
  if (!bus) {
    return fail("monitor", bus.error().message, bus.error().status);
  }
  auto watch = monitor::Watch::create(*bus.value(), robot.value());
  if (!watch) {
    return fail("monitor", watch.error().message);
  }
  if (o.once) {
    return show_once(*bus.value(), watch.value(), robot.value(), o);
  }
  try {
    // Here, so that the terminal is restored before errors are printed.
    Servers shown = std::move(servers).value();
    if (shown.foxglove != nullptr) {
      if (auto joined = shown.foxglove->join(*bus.value()); !joined) {
        return fail("monitor", joined.error().message);
      }
    }
    const auto screen = open_table(shown.displays, robot.value());
    if (!screen) {
      return fail("monitor", screen.error().message);
    }
    const int result = show(*bus.value(), watch.value(), shown, o, screen.value());
    const std::string summary = shown.foxglove == nullptr ? "" : shown.foxglove->summary();
    shown.displays.clear();  // the screen is the user's again
    if (!summary.empty()) {
      std::fprintf(stderr, "farrier monitor: %s\n", summary.c_str());
    }
    return result;
  } catch (const std::exception& problem) {
    return fail("monitor", problem.what());
  }
}

}  // namespace

std::function<int()> declare_monitor(CLI::App& app) {
  auto o = std::make_shared<MonitorOptions>();
  CLI::Option* once = app.add_flag("--once", o->once, "print one table and end");
  app.add_option("--prometheus", o->prometheus,
                 "serve metrics for Prometheus, of which docs/metrics.md has a list; :9464 is on this computer alone, "
                 "0.0.0.0:9464 on all its addresses")
      ->type_name("<address:port>")
      ->excludes(once);
  app.add_option("--foxglove", o->foxglove,
                 "serve Foxglove, Lichtblick and PlotJuggler by WebSocket; :8765 is on this computer alone, "
                 "0.0.0.0:8765 on all its addresses, for anybody to read")
      ->type_name("<address:port>")
      ->excludes(once);
  declare_web(app, o->web, once);
  declare_guest(app, o->guest);
  return [o] { return run_monitor(*o); };
}

}  // namespace farrier::cli
