#include "participant/options.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "bus/settings/peer_address.hpp"
#include "participant/fault_injection.hpp"

namespace farrier::participant {
namespace {

/// The values by their names, as CLI11 takes them.
template <class E, std::size_t N>
std::map<std::string, E> by_name(const std::array<Option<E>, N>& options) {
  std::map<std::string, E> values;
  for (const Option<E>& option : options) {
    values.emplace(option.name, option.value);
  }
  return values;
}

/// "sim_bridge is 0, estimator_service 1, ..., joint nodes and a standby 4 and up".
std::string numbers_text() {
  std::string text;
  for (const ProgramInfo& program : kPrograms) {
    const bool joint_node = program.program == Program::kJointNode;
    text += (text.empty() ? "" : ", ") + std::string(joint_node ? "joint nodes and a standby" : program.name) +
            (text.empty() ? " is " : " ") + std::to_string(program.number) + (joint_node ? " and up" : "");
  }
  return text;
}

/// The program of that name. Null for programs of others, which may stand in for any process.
const ProgramInfo* find_program(const std::string& name) {
  const auto found = std::ranges::find(kPrograms, name, &ProgramInfo::name);
  return found == kPrograms.end() ? nullptr : &*found;
}

/// True if a process of this program may have this number.
bool may_have(const std::string& program, bool stands_by, std::uint16_t number) {
  const ProgramInfo* const known = find_program(program);
  if (stands_by || (known != nullptr && known->program == Program::kJointNode)) {
    return number >= kFirstJointNode;
  }
  return known == nullptr || number == known->number;
}

/// True if the options of this program concern a process of that name.
bool concerns(Program program, const std::string& process) {
  const ProgramInfo* const known = find_program(process);
  return known == nullptr || known->program == program;
}

void declare_of_sim_bridge(CLI::App& app, ProcessOptions& o) {
  app.add_option("--trace", o.trace_path, "Trace file to write (CSV)");
  app.add_option("--simulated-robot", o.simulated_path,
                 "Robot file of the robot that is simulated, where it is not the one of --robot");
  app.add_option("--scene", o.scene_path, "Scene file of the ground under a body; a plane unless given");
}

void declare_of_locomotion(CLI::App& app, ProcessOptions& o) {
  app.add_option(
         "--velocity", o.velocity,
         "A body stands up and trots with this velocity: forward, left (m/s), yaw rate (rad/s); without, it lies "
         "until body/command says otherwise")
      ->expected(3)
      ->delimiter(',');
}

void declare_of_supervisor(CLI::App& app, ProcessOptions& o) {
  app.add_option("--design", o.design,
                 "Load the published gains are for: stance or swing in both slots, phases: each slot its own, or "
                 "adaptive: swing in both at first, then what the estimates say")
      ->capture_default_str();
  app.add_flag("--standby", o.standby, "Leads only when the supervisor that leads has fallen silent");
}

void declare_faults(CLI::App& app, ProcessOptions& o) {
  const FaultInjection* const injection = fault_injection();
  if (injection == nullptr) {
    return;
  }
  app.add_option("--fault", o.faults,
                 "Fault of samples on their way into this process, as TOPIC:KIND[=VALUE][@FROM..UNTIL][#KEY]")
      ->check([injection](const std::string& fault) {
        const auto checked = injection->check(fault);
        return checked ? std::string() : checked.error().message;
      })
      ->allow_extra_args(false);
}

void declare(CLI::App& app, ProcessOptions& o) {
  app.add_option("--name", o.name, "Name the others see")->capture_default_str();
  app.add_option("--robot", o.robot_path, "Robot file")->capture_default_str();
  app.add_option("--dds", o.vendor, "DDS vendor of this process (also FARRIER_DDS): cyclone or fast")
      ->envname("FARRIER_DDS")
      ->transform(CLI::CheckedTransformer(by_name(kDdsVendors)));
  app.add_option("--clock", o.clock, "lockstep or realtime")->transform(CLI::CheckedTransformer(by_name(kClockKinds)));
  app.add_option("--domain", o.network.domain, "DDS domain")->check(CLI::Range(0, 232))->capture_default_str();
  app.add_option("--address", o.network.address, "IPv4 address of the interface DDS uses")
      ->check(bus::address_error)
      ->capture_default_str();
  app.add_option("--peers", o.network.peers, "Computers to look for processes on, by IPv4 address or name")
      ->check(bus::peer_error)
      ->delimiter(',');
  app.add_option(
      "--security", o.security,
      "Folder of keys and permissions, as farrier security init makes it; without, DDS is open to everybody");
  app.add_option("--number", o.number, "This participant's number in the run")->required();
  app.add_option("--participants", o.participants, "How many take part in the run")->required();
  app.add_option("--session", o.session, "Session of the run; others are ignored")->capture_default_str();
  app.add_option("--seed", o.seed, "Seed of noise and touchdown times")->capture_default_str();
  app.add_option("--ticks", o.ticks, "Length of the run; 0: until SIGTERM")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  if (concerns(Program::kJointNode, o.name)) {
    app.add_option("--joints", o.joints, "Joints this process hosts")->delimiter(',');
  }
  if (concerns(Program::kSimBridge, o.name)) {
    declare_of_sim_bridge(app, o);
  }
  if (concerns(Program::kLocomotion, o.name)) {
    declare_of_locomotion(app, o);
  }
  if (concerns(Program::kSupervisor, o.name)) {
    declare_of_supervisor(app, o);
  }
  declare_faults(app, o);
  app.add_option("--gait", o.gait, "Gait, instead of the robot file's");
  app.add_option("--frequency", o.frequency_Hz, "Stride frequency in Hz, instead of the robot file's")
      ->check(CLI::Range(0.1, 10.0));
  app.add_option("--estimator", o.estimator, "Estimator section of the robot file that every joint uses");
  app.add_option("--controller", o.controller, "Kind of every controller, instead of the robot file's");
  app.add_option("--world", o.world,
                 "bench: each joint on a load of its own; body: the whole robot on a ground; ideal: there, on ideal "
                 "torques. On a ground joints have the controllers of locomotion")
      ->transform(CLI::CheckedTransformer(by_name(kWorlds)));
  app.add_option("--slow", o.slow, "Slow motion: the clock goes slower than the machine's by this factor")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--priority-shift", o.priority_shift,
                 "Added to every SCHED_FIFO priority of the process, real time only")
      ->check(CLI::Range(-39, 15))
      ->capture_default_str();
  app.add_flag("--no-dither", o.no_dither, "Valves are not probed, whatever the robot file says");
}

}  // namespace

const FaultInjection*& fault_injection() noexcept {
  static const FaultInjection* linked = nullptr;
  return linked;
}

ProcessOptions parse_options(const std::string& process, const std::string& purpose, int argc, char** argv) {
  CLI::App app(purpose, process);
  ProcessOptions options;
  options.name = process;
  declare(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    std::exit(app.exit(problem) == 0 ? 0 : 2);
  }
  if (options.number >= options.participants) {
    std::fprintf(stderr, "%s: --number %u must be below --participants %u\n", process.c_str(), options.number,
                 options.participants);
    std::exit(2);
  }
  if (!may_have(process, options.standby, options.number)) {
    std::fprintf(stderr, "%s: --number %u is another participant's: %s\n", process.c_str(), options.number,
                 numbers_text().c_str());
    std::exit(2);
  }
  if (!options.faults.empty() && options.clock == bus::ClockKind::kLockstep) {
    std::fprintf(stderr,
                 "%s: --fault is for the real-time clock: in lock-step a lost sample holds the run up for ever\n",
                 process.c_str());
    std::exit(2);
  }
  if (options.standby && options.clock == bus::ClockKind::kLockstep) {
    std::fprintf(stderr,
                 "%s: --standby is for the real-time clock: in lock-step a run waits for a supervisor that is silent\n",
                 process.c_str());
    std::exit(2);
  }
  if (options.session == 0) {
    std::fprintf(stderr, "%s: --session must not be 0, which stands for no session\n", process.c_str());
    std::exit(2);
  }
  return options;
}

bus::NetworkOptions network_of(const ProcessOptions& options) {
  bus::NetworkOptions network = options.network;
  if (options.clock == bus::ClockKind::kLockstep) {
    network.lease = bus::kPatientLease;
  }
  return network;
}

namespace {

/// All digits: these numbers shape the trace.
std::string exact_text(double number) {
  char exact[32];
  std::snprintf(exact, sizeof exact, "%.17g", number);
  return exact;
}

std::vector<std::string> exact_texts(const std::vector<double>& numbers) {
  std::vector<std::string> texts;
  std::ranges::transform(numbers, std::back_inserter(texts), exact_text);
  return texts;
}

}  // namespace

std::vector<std::string> to_arguments(const ProcessOptions& o) {
  const auto joined = [](const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) {
      text += (text.empty() ? "" : ",") + part;
    }
    return text;
  };
  std::vector<std::string> arguments{"--name",         o.name,
                                     "--robot",        o.robot_path,
                                     "--dds",          to_string(o.vendor),
                                     "--clock",        name_of(kClockKinds, o.clock),
                                     "--domain",       std::to_string(o.network.domain),
                                     "--address",      o.network.address,
                                     "--peers",        joined(o.network.peers),
                                     "--number",       std::to_string(o.number),
                                     "--participants", std::to_string(o.participants),
                                     "--session",      std::to_string(o.session),
                                     "--seed",         std::to_string(o.seed),
                                     "--ticks",        std::to_string(o.ticks)};
  const auto append = [&](const char* flag, const std::string& value) {
    if (!value.empty()) {
      arguments.insert(arguments.end(), {flag, value});
    }
  };
  append("--security", o.security);
  switch (role_of(o.number, o.standby)) {
    case bus::Role::kJointNode:
      append("--joints", joined(o.joints));
      break;
    case bus::Role::kSimBridge:
      append("--trace", o.trace_path);
      append("--simulated-robot", o.simulated_path);
      append("--scene", o.scene_path);
      break;
    case bus::Role::kLocomotion:
      append("--velocity", joined(exact_texts(o.velocity)));
      break;
    case bus::Role::kSupervisor:
      append("--design", o.design);
      break;
    default:
      break;
  }
  append("--gait", o.gait);
  if (o.frequency_Hz > 0) {
    append("--frequency", exact_text(o.frequency_Hz));
  }
  append("--estimator", o.estimator);
  append("--controller", o.controller);
  if (is_on_ground(o.world)) {
    append("--world", name_of(kWorlds, o.world));
  }
  if (o.slow != 1) {
    append("--slow", std::to_string(o.slow));
  }
  if (o.priority_shift != 0) {
    append("--priority-shift", std::to_string(o.priority_shift));
  }
  for (const std::string& fault : o.faults) {
    append("--fault", fault);
  }
  if (o.standby) {
    arguments.push_back("--standby");
  }
  if (o.no_dither) {
    arguments.push_back("--no-dither");
  }
  return arguments;
}

}  // namespace farrier::participant
