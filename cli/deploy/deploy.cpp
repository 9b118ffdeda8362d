// farrier deploy: renders the files of each computer of a robot from the robot file, and checks this computer.

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "robot/robot.hpp"
#include "runtime/realtime_thread.hpp"
#include "cli/base/command.hpp"
#include "cli/deploy/findings.hpp"
#include "tools/deploy/host_findings.hpp"
#include "tools/deploy/rendered_folder.hpp"

namespace farrier::cli {
namespace {

struct DeployOptions {
  std::string action;
  std::string robot_path;
  std::string host;
  std::string out;
  std::string at;
  std::string prefix = "/usr";
};

std::string this_computer() {
  char name[256] = {};
  ::gethostname(name, sizeof name - 1);
  return name;
}

deploy::Places places_of(const DeployOptions& o, const robot::Robot& robot) {
  deploy::Places places = deploy::standard_places(robot);
  places.prefix = o.prefix;
  if (!o.at.empty()) {
    places.folder = std::filesystem::absolute(o.at).lexically_normal().string();
  }
  return places;
}

/// Returns the steps by which a person installs the folder, once.
std::string instructions(const robot::Robot& robot, const std::string& host, const deploy::Places& places) {
  const std::string& folder = places.folder;
  const std::string check = "farrier deploy check " + places.robot_file(robot) + " --host " + host + " --at " + folder;
  return "Rendered by farrier deploy render for host " + host + " of " + robot.name +
         ". On that host, as root, with this folder at " + folder + ":\n" +
         "  " + check + "\n" +
         "  cp " + folder + "/60-farrier-" + robot.name + ".conf /etc/sysctl.d/ && sysctl --system\n" +
         "  systemctl link " + folder + "/*.service\n" +
         "  systemctl enable --now " + folder + "/" + deploy::target_of(robot) + "\n";
}

int render(const DeployOptions& o, const robot::Robot& robot, const deploy::Places& places,
           const std::vector<deploy::RenderedFile>& files) {
  if (o.out.empty()) {
    return refuse("deploy", "render needs --out: the folder that gets the files");
  }
  const std::string how = instructions(robot, o.host, places);
  if (auto written = deploy::write_folder(o.out, files, how); !written) {
    return refuse("deploy", written.error().message);
  }
  for (const deploy::RenderedFile& file : files) {
    std::printf("%s/%s\n", o.out.c_str(), file.name.c_str());
  }
  std::printf("\n%s", how.c_str());
  return kPassed;
}

int check(const robot::Robot& robot, const std::string& host, const deploy::Places& places,
          const std::vector<deploy::RenderedFile>& files) {
  const robot::Host& section = *config::find(robot.file.deployment->hosts, host);
  const auto processes = deploy::processes_of(robot, host, places);
  const deploy::HostFacts facts = deploy::this_host(runtime::kControlPriority + section.priority_shift);
  deploy::Findings findings = deploy::host_findings(facts, *robot.file.deployment, section);
  deploy::append(findings, deploy::file_findings(processes.value(), places,
                                                 deploy::differing_files(places.folder, files)));
  return print_findings(findings, host + " of " + robot.name);
}

int run_deploy(DeployOptions o) {
  const auto robot = robot::load_robot(o.robot_path);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  if (o.host.empty()) {
    o.host = this_computer();
  }
  const deploy::Places places = places_of(o, robot.value());
  const auto files = deploy::render_host(robot.value(), deploy::text_of(o.robot_path).value_or(""), o.host, places);
  if (!files) {
    return refuse("deploy", files.error().message);
  }
  return o.action == "render" ? render(o, robot.value(), places, files.value())
                              : check(robot.value(), o.host, places, files.value());
}

}  // namespace

std::function<int()> declare_deploy(CLI::App& app) {
  auto o = std::make_shared<DeployOptions>();
  app.add_option("action", o->action, "render a host's files, or check this computer against them")
      ->required()
      ->check(CLI::IsMember({"render", "check"}));
  app.add_option("robot", o->robot_path, "robot file with a deployment section")->required()->type_name("<file>");
  app.add_option("--host", o->host, "host of the deployment")->type_name("<name>")->default_str("this computer's name");
  app.add_option("--out", o->out, "render: folder that gets the files")->type_name("<dir>");
  app.add_option("--at", o->at, "where that folder stands on the host")
      ->type_name("<dir>")
      ->default_str("/etc/farrier/ and the robot's name");
  app.add_option("--prefix", o->prefix, "where the host has Farrier installed")
      ->type_name("<dir>")
      ->capture_default_str();
  return [o] { return run_deploy(*o); };
}

}  // namespace farrier::cli
