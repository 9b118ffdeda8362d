#include "tools/deploy/deployed_processes.hpp"

namespace farrier::deploy {
namespace {

participant::ProcessOptions options_for_all(const robot::Robot& robot, const Places& places) {
  const robot::Deployment& deployment = *robot.file.deployment;
  participant::ProcessOptions options;
  options.robot_path = places.robot_file(robot);
  options.clock = deployment.clock;
  options.session = static_cast<std::uint64_t>(deployment.session);
  options.design = name_of(robot::kDesigns, deployment.design);
  options.no_dither = deployment.design != robot::Design::kAdaptive;  // as farrier trot: nothing to learn, nothing to probe
  options.network.domain = deployment.domain;
  options.network.peers.clear();
  options.participants = participant::kFirstJointNode;
  for (const auto& [name, host] : deployment.hosts) {
    options.network.peers.push_back(host.address);
    for (const auto& [process_name, process] : host.processes) {
      if (process.program == robot::Program::kJointNode) {
        ++options.participants;
      }
    }
  }
  return options;
}

std::string names_of_hosts(const robot::Deployment& deployment) {
  std::string names;
  for (const auto& [name, host] : deployment.hosts) {
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

}  // namespace

std::string Places::executable(robot::Program program) const {
  return prefix + "/libexec/farrier/" + robot::to_string(program);
}

std::string Places::robot_file(const robot::Robot& robot) const { return folder + "/" + robot.name + ".yaml"; }

Places standard_places(const robot::Robot& robot) { return {.folder = "/etc/farrier/" + robot.name}; }

Result<std::vector<DeployedProcess>> processes_of(const robot::Robot& robot, const std::string& host,
                                                  const Places& places) {
  if (!robot.file.deployment) {
    return Error{robot.path + ": has no deployment: add that section, docs/deploy.md says how"};
  }
  const robot::Deployment& deployment = *robot.file.deployment;
  if (config::find(deployment.hosts, host) == nullptr) {
    return Error{robot.path + ": deployment.hosts: no host '" + host + "': give one of " + names_of_hosts(deployment)};
  }
  participant::ProcessOptions options = options_for_all(robot, places);
  std::uint16_t next_joint_node = participant::kFirstJointNode;
  std::vector<DeployedProcess> here;
  for (const auto& [host_name, section] : deployment.hosts) {
    options.network.address = section.address;
    options.vendor = section.vendor;
    options.priority_shift = section.priority_shift;
    for (const auto& [name, process] : section.processes) {
      options.name = name;
      options.joints = process.joints;
      options.number =
          process.program == Program::kJointNode ? next_joint_node++ : info(process.program).number;
      if (host_name == host) {
        here.push_back({process, options});
      }
    }
  }
  if (here.size() >= static_cast<std::size_t>(options.network.max_processes)) {
    return Error{robot.path + ": deployment.hosts." + host + ": has " + std::to_string(here.size()) +
                 " processes, but DDS finds fewer than " + std::to_string(options.network.max_processes) +
                 " on a host: let joint_nodes host more joints each"};
  }
  return here;
}

}  // namespace farrier::deploy
