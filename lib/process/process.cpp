#include "process/process.hpp"

#include <cstdio>

#include "bus/settings/user_settings.hpp"
#include "bus_factory/bus_factory.hpp"
#include "participant/fault_injection.hpp"
#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "runtime/realtime_thread.hpp"
#include "security/credentials.hpp"

namespace farrier::process {
namespace {

int refuse(const char* name, const Error& error, int status = 1) {
  std::fprintf(stderr, "%s: %s\n", name, error.message.c_str());
  return status;
}

}  // namespace

Result<robot::Robot, config::Problems> load_robot(const participant::ProcessOptions& options) {
  robot::Overrides overrides;
  if (!options.gait.empty()) {
    const auto pattern = parse_choice("gait", gait::kPatterns, options.gait);
    if (!pattern) {
      return config::Problems{{options.robot_path, 0, "--gait", pattern.error().message}};
    }
    overrides.pattern = pattern.value();
  }
  if (options.frequency_Hz > 0) {
    overrides.frequency_Hz = options.frequency_Hz;
  }
  overrides.without_dither = options.no_dither;
  overrides.on_ground = options.world == participant::World::kBody;
  if (!options.estimator.empty()) {
    overrides.estimator = options.estimator;
  }
  if (!options.controller.empty()) {
    const auto kind = parse_choice("controller", robot::kControllerKinds, options.controller);
    if (!kind) {
      return config::Problems{{options.robot_path, 0, "--controller", kind.error().message}};
    }
    overrides.controller = kind.value();
  }
  return robot::load_robot(options.robot_path, overrides);
}

participant::Identity identity_of(const participant::ProcessOptions& options, const robot::Robot& robot) {
  return {options.name,    robot.name,    options.number, options.participants,
          options.session, options.clock, options.slow,   options.standby ? 0 : 1};
}

Result<Done> secure(bus::NetworkOptions& network, const std::string& folder, bus::Role role, bus::Vendor vendor) {
  if (folder.empty()) {
    return Done{};
  }
  auto files = FARRIER_TRY(security::credentials(folder, role, vendor, participant::date_now()));
  network.security = std::move(files);
  return Done{};
}

int run(const participant::ProcessOptions& options, const Factory<participant::Application>& polled,
        const Factory<participant::RealtimeApplication>& threaded) {
  participant::install_signal_handlers();
  const char* const name = options.name.c_str();
  const auto robot = load_robot(options);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return 2;
  }
  bool unknown_joint = false;
  for (const std::string& joint : options.joints) {
    if (robot.value().find(joint) == nullptr) {
      std::fprintf(stderr, "%s: --joints: %s has no joint '%s'\n", name, robot.value().name.c_str(), joint.c_str());
      unknown_joint = true;
    }
  }
  if (unknown_joint) {
    return 2;
  }
  bus::NetworkOptions network = participant::network_of(options);
  const bus::Role role = participant::role_of(options.number, options.standby);
  if (auto secured = secure(network, options.security, role, options.vendor); !secured) {
    return refuse(name, secured.error(), 2);
  }
  if (options.clock == bus::ClockKind::kRealtime) {
    participant::set_slow_motion(options.slow);
    runtime::use_small_stacks();
    if (const std::string lacking = runtime::set_priority(runtime::kJoiningPriority + options.priority_shift);
        !lacking.empty()) {
      std::fprintf(stderr, "%s: its bus runs without %s\n", name, lacking.c_str());
    }
  }
  std::fputs(bus::lines_of_user_settings(network, options.name + ": ").c_str(), stderr);
  auto bus = bus_factory::create_bus(options.vendor, network);
  if (!bus) {
    return refuse(name, bus.error());
  }
  if (!options.faults.empty()) {
    std::fprintf(stderr, "%s: runs with %zu faults on purpose\n", name, options.faults.size());
    bus = participant::fault_injection()->into(std::move(bus).value(), options);
  }
  auto member = participant::Participant::join(*bus.value(), identity_of(options, robot.value()));
  if (!member) {
    return refuse(name, member.error());
  }
  if (options.clock == bus::ClockKind::kRealtime && threaded) {
    auto application = threaded(*member.value(), robot.value());
    if (!application) {
      return refuse(name, application.error());
    }
    const participant::Priorities priorities =
        participant::priorities_of(*application.value(), options.priority_shift, !options.security.empty());
    return participant::run_realtime(*application.value(), *member.value(), priorities);
  }
  auto application = polled(*member.value(), robot.value());
  participant::Promotion promotion;
  const bool service = role == bus::Role::kEstimatorService || role == bus::Role::kSupervisor;
  if (options.clock == bus::ClockKind::kRealtime && !service) {
    promotion = {runtime::kJoiningPriority + options.priority_shift, runtime::kBusPriority + options.priority_shift};
  }
  return application ? participant::run(*application.value(), *member.value(), promotion)
                     : refuse(name, application.error());
}

}  // namespace farrier::process
