// farrier export: a recording as a bag of rosbag2.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "cli/base/command.hpp"
#include "cli/base/help.hpp"
#include "cli/base/long_work.hpp"
#include "participant/loop.hpp"
#include "ros_messages/names.hpp"
#include "tools/ros_bag/export_bag.hpp"

namespace farrier::cli {
namespace {

struct ExportPaths {
  bool ros2 = false;
  std::string from, to;
  ros_bag::ExportOptions options;
};

int run_export(const ExportPaths& o) {
  const KeepOn keep_on = long_work("export");
  const auto exported = ros_bag::export_bag(o.from, o.to, o.options, keep_on);
  if (participant::stop_requested() && !exported) {
    return participant::stop_status();
  }
  if (!exported) {
    return refuse("export", exported.error().message);
  }
  std::printf("%s: %llu messages\n", o.to.c_str(), static_cast<unsigned long long>(exported.value().messages));
  for (const std::string& topic : exported.value().missing) {
    std::printf("without %s: the recording has no samples for it\n", topic.c_str());
  }
  if (!exported.value().ending.empty()) {
    return fail("export", o.from + ": " + exported.value().ending + "; the rest is exported");
  }
  return kPassed;
}

}  // namespace

std::function<int()> declare_export(CLI::App& app) {
  auto o = std::make_shared<ExportPaths>();
  app.add_flag("--ros2", o->ros2, "as a bag of rosbag2: MCAP with messages of ROS 2, and metadata.yaml")->required();
  app.add_option("from", o->from, "recording of farrier record or of farrier trot")->required()->type_name("<file>");
  app.add_option("to", o->to, "folder of the bag, which must not be there yet")->required()->type_name("<folder>");
  app.add_option("--ros-namespace", o->options.ros_namespace, "namespace of the topics")
      ->check(ros_messages::namespace_error)
      ->type_name("<name>")
      ->default_str("/ and the robot's name");
  app.add_option("--rate", o->options.rate_Hz, "joint_states, imu, odom and foot wrenches a second")
      ->check(between(1.0, 1000.0))
      ->type_name("<Hz>")
      ->capture_default_str();
  return [o] { return run_export(*o); };
}

}  // namespace farrier::cli
