// farrier robot: a robot file as a URDF, and a URDF held against a robot file.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <memory>

#include "cli/base/command.hpp"
#include "cli/base/output_file.hpp"
#include "core/text.hpp"
#include "robot/robot.hpp"
#include "urdf/comparison.hpp"
#include "urdf/urdf_reader.hpp"
#include "urdf/urdf_text.hpp"

namespace farrier::cli {
namespace {

struct RobotOptions {
  std::string action;
  std::vector<std::string> files;
  std::string out;
};

int write_urdf(const RobotOptions& o, const robot::Robot& robot) {
  const auto text = urdf::urdf_text(robot);
  if (!text) {
    return refuse("robot", text.error().message);
  }
  if (o.out.empty()) {
    std::fputs(text.value().c_str(), stdout);
    return kPassed;
  }
  if (auto way = make_way({o.out}, o.files); !way) {
    return refuse("robot", way.error().message);
  }
  std::ofstream file(o.out, std::ios::binary);
  file << text.value() << std::flush;
  return file ? kPassed : fail("robot", o.out + " cannot be written");
}

void print_list(const char* heading, const std::vector<std::string>& entries) {
  if (entries.empty()) {
    return;
  }
  std::printf("%s\n", heading);
  for (const std::string& entry : entries) {
    std::printf("  %s\n", entry.c_str());
  }
}

int check(const std::string& path, const robot::Robot& robot) {
  const auto model = urdf::read_urdf(path);
  if (!model) {
    std::fputs(config::to_string(model.error()).c_str(), stderr);
    return kBadInput;
  }
  if (!robot.body) {
    return refuse("robot", robot.path + " describes no rigid bodies to compare: give body.trunk (docs/robots.md)");
  }
  const urdf::Comparison found = urdf::compare(model.value(), robot);
  for (const urdf::Difference& difference : found.differences) {
    std::printf("%s%s%s\n", difference.where.c_str(), difference.where.empty() ? "" : ": ", difference.message.c_str());
  }
  print_list("A robot file has no place for:", found.only_in_urdf);
  print_list("A URDF has no place for:", found.only_in_robot);
  std::printf("%s of %s against %s of %s: %s\n",
              counted(static_cast<std::uint64_t>(found.compared_joints), "joint").c_str(), path.c_str(),
              counted(robot.joints.size(), "joint").c_str(), robot.path.c_str(),
              counted(found.differences.size(), "difference").c_str());
  return found.differences.empty() ? kPassed : kFailed;
}

int run_robot(const RobotOptions& o) {
  const bool writes = o.action == "urdf";
  if (o.files.size() != (writes ? 1u : 2u)) {
    return refuse("robot", writes ? "urdf takes one robot file: farrier robot urdf hyq.yaml"
                                  : "check takes a URDF and a robot file: farrier robot check robot.urdf hyq.yaml");
  }
  if (!writes && !o.out.empty()) {
    return refuse("robot", "--out is where urdf writes; check prints");
  }
  const auto robot = robot::load_robot(o.files.back());
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  return writes ? write_urdf(o, robot.value()) : check(o.files.front(), robot.value());
}

}  // namespace

std::function<int()> declare_robot(CLI::App& app) {
  auto o = std::make_shared<RobotOptions>();
  app.add_option(
         "action", o->action,
         "urdf writes a robot file as a URDF; check prints each difference between a URDF and a robot file, and "
         "ends with status 1 if there is one")
      ->required()
      ->check(CLI::IsMember({"urdf", "check"}));
  app.add_option("files", o->files, "urdf: the robot file; check: the URDF, then the robot file")
      ->required()
      ->expected(1, 2)
      ->type_name("<file>...");
  app.add_option("--out", o->out, "urdf: file that gets the URDF")->type_name("<file>")->default_str("standard output");
  return [o] { return run_robot(*o); };
}

}  // namespace farrier::cli
