// farrier request: what an operator asks of a running robot's supervisor.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>

#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "participant/operator.hpp"
#include "process/process.hpp"
#include "cli/base/command.hpp"
#include "cli/record/guest.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

/// For discovery, the request's way and the answer's.
constexpr auto kPatience = 5s;

struct RequestOptions {
  std::string what;
  std::uint64_t session = 0;
  GuestOptions guest;
};

/// Asks until the supervisor answers; the mode of its answer.
std::optional<signals::SystemMode> ask(bus::Bus& bus, bus::Publisher<signals::SystemRequest>& requests,
                                       bus::Subscription<signals::SystemMode>& modes,
                                       participant::ModeRequest request) {
  const SteadyTime end = participant::steady_now() + kPatience;
  while (!request.answer() && participant::steady_now() < end && !participant::stop_requested()) {
    const std::uint64_t arrivals = bus.arrivals();
    modes.drain([&](const signals::SystemMode& mode) { request.take(mode); });
    if (const auto due = request.due(participant::steady_now(), requests.matched_readers() > 0)) {
      requests.publish(*due);
    }
    bus.wait_for_arrivals(arrivals + 1, 20ms);
  }
  return request.answer();
}

int run_request(const RequestOptions& o) {
  participant::install_signal_handlers();
  participant::ProcessOptions file;
  file.robot_path = o.guest.robot_path;
  const auto robot = process::load_robot(file);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  auto bus = join_as_guest(o.guest, bus::Role::kOperator);
  if (!bus) {
    return fail("request", bus.error().message, bus.error().status);
  }
  const participant::Identity identity = participant::operator_of(robot.value().name, o.session);
  auto requests = bus::Publisher<signals::SystemRequest>::create(
      *bus.value(), participant::endpoint_of(identity, bus::TopicId::kSystemRequest));
  auto modes = bus::Subscription<signals::SystemMode>::create(
      *bus.value(), participant::endpoint_of(identity, bus::TopicId::kSystemMode));
  if (!requests || !modes) {
    return fail("request", !requests ? requests.error().message : modes.error().message);
  }
  const signals::Request asked = o.what == "arm" ? signals::Request::kArm : signals::Request::kStop;
  const auto answer = ask(*bus.value(), requests.value(), modes.value(), {o.session, asked});
  if (!answer) {
    return fail("request", "no supervisor of " + robot.value().name + ", session " + std::to_string(o.session) +
                               ", domain " + std::to_string(o.guest.network.domain) +
                               " answers: look for its --session and --domain in its command line (ps)");
  }
  std::printf("%s is %s, epoch %u\n", robot.value().name.c_str(), signals::to_string(answer->mode), answer->epoch);
  return kPassed;
}

}  // namespace

std::function<int()> declare_request(CLI::App& app) {
  auto o = std::make_shared<RequestOptions>();
  app.add_option("what", o->what, "arm or stop")->required()->check(CLI::IsMember({"arm", "stop"}));
  app.add_option("--session", o->session, "session of the run")->required()->type_name("<number>");
  declare_guest(app, o->guest);
  return [o] { return run_request(*o); };
}

}  // namespace farrier::cli
