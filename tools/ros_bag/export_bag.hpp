#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/keep_on.hpp"
#include "core/result.hpp"

namespace farrier::ros_bag {

struct ExportOptions {
  std::string ros_namespace;  ///< "/" or "/hyq"; empty: "/" and the robot's name
  double rate_Hz = 100.0;     ///< of joint states, imu, odom and foot wrenches; 1 to 1000
};

/// A bag that has been made.
struct Exported {
  std::uint64_t messages = 0;
  std::vector<std::string> missing;  ///< topics of which the recording has no samples
  std::string ending;                ///< reason why the recording is not whole; empty: it is
};

/// Makes a bag of rosbag2 of a recording: the folder, which must not be there yet. Times are dates of samples; of a
/// recording that says that its clock was lock-step, the date of its begin and simulated time since then. Refuses what
/// RecordedRun and BagWriter refuse, a recording without a sample that ROS could have, and when `keep_on` does; nothing is
/// then left of the folder.
Result<Exported> export_bag(const std::string& recording, const std::string& folder, const ExportOptions& options,
                            const KeepOn& keep_on = {});

}  // namespace farrier::ros_bag
