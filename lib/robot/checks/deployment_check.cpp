#include "robot/checks/deployment_check.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "config/suggest.hpp"

namespace farrier::robot {
namespace {

/// Where a thing that must be alone was seen first.
using FirstSeen = std::map<std::string, std::string>;

class DeploymentCheck {
 public:
  DeploymentCheck(const RobotFile& file, const Deployment& deployment) : deployment_(deployment) {
    for (const auto& [leg_name, leg] : file.legs) {
      for (const auto& [joint, kind] : leg.joints) {
        joints_.push_back(joint);
      }
    }
  }

  config::Problems run() {
    for (const auto& [host_name, host] : deployment_.hosts) {
      check_address(host_name, host);
      for (const auto& [name, process] : host.processes) {
        alone(processes_, name, host_name, process.place, "", "is a process of host ");
        check_process(name, process);
      }
    }
    for (const std::string& joint : joints_) {
      if (!hosts_of_joint_.contains(joint)) {
        report("hosts", "no joint_node has joint " + joint + ": add it to the joints of one");
      }
    }
    for (const ProgramInfo& one : kPrograms) {
      // A planner of the user's own can take the place of locomotion. Joint nodes are judged by their joints.
      const bool may_miss = one.program == Program::kLocomotion || one.program == Program::kJointNode;
      if (!may_miss && !programs_.contains(one.name)) {
        report("hosts", "no process has program " + std::string(one.name) + ": a robot needs one");
      }
    }
    return std::move(problems_);
  }

 private:
  void report(const std::string& key, std::string message) {
    problems_.push_back(deployment_.place.problem(key, std::move(message)));
  }

  void alone(FirstSeen& seen, const std::string& what, const std::string& where, const config::Place& place,
             const std::string& key, const std::string& message) {
    const auto [first, is_new] = seen.emplace(what, where);
    if (!is_new) {
      problems_.push_back(place.problem(key, message + first->second + " too: it can be there once"));
    }
  }

  void check_address(const std::string& name, const Host& host) {
    alone(addresses_, host.address, name, host.place, "address", host.address + " is the address of host ");
    if (deployment_.hosts.size() > 1 && host.address.starts_with("127.")) {
      problems_.push_back(host.place.problem(
          "address", host.address + " is every computer itself: give the address at which the other hosts reach it"));
    }
  }

  void check_process(const std::string& name, const DeployedProcess& process) {
    if (process.program != Program::kJointNode) {
      const std::string program = to_string(process.program);
      alone(programs_, program, name, process.place, "program", program + " is the program of process ");
      if (!process.joints.empty()) {
        problems_.push_back(process.place.problem("joints", program + " hosts none: only a joint_node does"));
      }
      return;
    }
    if (process.joints.empty()) {
      problems_.push_back(process.place.problem("joints", "a joint_node needs at least one joint: give [ name, ... ]"));
    }
    for (const std::string& joint : process.joints) {
      if (std::ranges::find(joints_, joint) == joints_.end()) {
        const std::string meant = config::suggest(joint, joints_).name;
        problems_.push_back(process.place.problem(
            "joints", joint + " is not a joint of a leg" + (meant.empty() ? "" : ": did you mean " + meant + "?")));
      }
      alone(hosts_of_joint_, joint, name, process.place, "joints", joint + " is hosted by process ");
    }
  }

  const Deployment& deployment_;
  std::vector<std::string> joints_;
  FirstSeen processes_, programs_, addresses_, hosts_of_joint_;
  config::Problems problems_;
};

}  // namespace

config::Problems check_deployment(const RobotFile& file) {
  return file.deployment ? DeploymentCheck(file, *file.deployment).run() : config::Problems{};
}

}  // namespace farrier::robot
