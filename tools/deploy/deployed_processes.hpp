#pragma once

#include <string>
#include <vector>

#include "participant/options.hpp"
#include "robot/robot.hpp"

namespace farrier::deploy {

/// Where a host has things.
struct Places {
  std::string prefix = "/usr";  ///< of the packages: processes are in libexec/farrier below it
  std::string folder;           ///< that the rendered files stand in, with the robot file

  std::string executable(robot::Program program) const;
  std::string robot_file(const robot::Robot& robot) const;
};

/// Where the packages and `farrier deploy render` without options put them: /usr, /etc/farrier/<robot>.
Places standard_places(const robot::Robot& robot);

/// A process of a host and the options it is started with.
struct DeployedProcess {
  robot::DeployedProcess section;
  participant::ProcessOptions options;
};

/// The processes of a host, in the order of the file. Numbers and peers are the same whichever host is asked for: joint
/// nodes are numbered through all hosts, every host is a peer. Refuses a robot file without deployment and a host that
/// is not one of it.
Result<std::vector<DeployedProcess>> processes_of(const robot::Robot& robot, const std::string& host,
                                                  const Places& places);

}  // namespace farrier::deploy
