#include "tools/deploy/rendering.hpp"

#include <algorithm>
#include <filesystem>

#include "config/visitor.hpp"
#include "runtime/realtime_thread.hpp"

namespace farrier::deploy {
namespace {

// Rights that a break-in could use are removed. Real-time priorities come from LimitRTPRIO, so no capability is needed.
constexpr const char* kHardening = R"(NoNewPrivileges=yes
CapabilityBoundingSet=
AmbientCapabilities=
ProtectSystem=strict
ProtectHome=yes
PrivateTmp=yes
ProtectClock=yes
ProtectControlGroups=yes
ProtectHostname=yes
ProtectKernelLogs=yes
ProtectKernelModules=yes
ProtectKernelTunables=yes
ProtectProc=invisible
RestrictNamespaces=yes
RestrictSUIDSGID=yes
LockPersonality=yes
MemoryDenyWriteExecute=yes
SystemCallArchitectures=native
SystemCallFilter=@system-service
UMask=0077
)";

// A process is no user and needs nothing of the system but its network.
constexpr const char* kOfAProcess = R"(DynamicUser=yes
PrivateDevices=yes
RestrictAddressFamilies=AF_INET AF_NETLINK AF_UNIX
)";

/// A word of ExecStart=, systemd.service(5): specifiers and variables are doubled, the rest is quoted.
std::string unit_word(const std::string& word) {
  std::string text;
  bool plain = !word.empty();
  for (const char c : word) {
    plain = plain && c != ' ' && c != '\t' && c != '"' && c != '\'' && c != '\\' && c != ';';
    if (c == '"' || c == '\\') {
      text += '\\';
    } else if (c == '%' || c == '$') {
      text += c;
    }
    text += c;
  }
  return plain ? text : '"' + text + '"';
}

std::string joined(const auto& items, const auto& text_of) {
  std::string text;
  for (const auto& item : items) {
    text += (text.empty() ? "" : " ") + text_of(item);
  }
  return text;
}

std::string heading(const robot::Robot& robot, const std::string& host) {
  return "# Rendered by farrier deploy render for host " + host + " of " + robot.name +
         ": changes are lost when it is rendered again.\n";
}

std::string unit_text(const robot::Robot& robot, const std::string& host, const Places& places,
                      const DeployedProcess& process) {
  const participant::ProcessOptions& options = process.options;
  const auto as_is = [](const std::string& text) { return text; };
  std::string text = heading(robot, host);
  text += "[Unit]\nDescription=Farrier " + robot.name + ": " + options.name +
          (options.joints.empty() ? "" : " (" + joined(options.joints, as_is) + ")") + "\n";
  text += "PartOf=" + target_of(robot) + "\nWants=network-online.target\nAfter=network-online.target\n";
  text += "# A robot's process comes back however often it dies.\nStartLimitIntervalSec=0\n\n";
  text += "[Service]\nType=notify\nNotifyAccess=main\n";
  text += "ExecStart=" + unit_word(places.executable(process.section.program)) + " " +
          joined(participant::to_arguments(options), unit_word) + "\n";
  text += "# Start-up is complete when all processes of all hosts have greeted each other.\nTimeoutStartSec=infinity\n";
  text += "TimeoutStopSec=5\nWatchdogSec=" + config::number_text(robot.file.deployment->watchdog_s) + "\n";
  text += "TimeoutAbortSec=2\nRestart=on-failure\nRestartSec=200ms\n# Input it refused will not get better.\n";
  text += "RestartPreventExitStatus=2\n\n";
  if (!process.section.cpus.empty()) {
    text += "CPUAffinity=" + joined(process.section.cpus, [](int cpu) { return std::to_string(cpu); }) + "\n";
  }
  if (options.clock == bus::ClockKind::kRealtime) {
    text += "# The process gives each of its threads its priority; the unit only allows it.\n";
    text += "LimitRTPRIO=" + std::to_string(runtime::kControlPriority + options.priority_shift) + "\n";
    text += "LimitMEMLOCK=infinity\n";
  }
  text += "MemoryMax=" + std::to_string(process.section.memory_max_MB) + "M\nOOMScoreAdjust=-500\n\n";
  return text + kOfAProcess + kHardening + "\n[Install]\nWantedBy=" + target_of(robot) + "\n";
}

// The units of processes hide devices from them; this one is root for one file, with no right beside it.
std::string awake_text(const robot::Robot& robot, const std::string& host) {
  return heading(robot, host) + "[Unit]\nDescription=Farrier " + robot.name +
         ": processors that do not sleep\nPartOf=" + target_of(robot) + R"(

[Service]
Type=exec
# The kernel holds to it while the file is open.
ExecStart=/bin/sh -c 'exec 3>/dev/cpu_dma_latency && echo 0 >&3 && exec sleep infinity'
Restart=on-failure

PrivateNetwork=yes
DevicePolicy=closed
DeviceAllow=/dev/cpu_dma_latency rw
RestrictAddressFamilies=none
)" + kHardening + "\n[Install]\nWantedBy=" + target_of(robot) + "\n";
}

std::string target_text(const robot::Robot& robot, const std::string& host, const std::vector<RenderedFile>& units) {
  const auto name = [](const RenderedFile& unit) { return unit.name; };
  return heading(robot, host) + "[Unit]\nDescription=Farrier " + robot.name + " on " + host + "\nWants=" +
         joined(units, name) + "\n\n[Install]\nWantedBy=multi-user.target\n";
}

std::string network_text(const robot::Robot& robot, const std::string& host) {
  const std::string& interface = config::find(robot.file.deployment->hosts, host)->interface;
  const std::string bytes = std::to_string(bus::kSocketBufferBytes);
  return heading(robot, host) + "# What DDS asks for its sockets; the kernel grants no more than this.\n" +
         "net.core.rmem_max = " + bytes + "\nnet.core.wmem_max = " + bytes + "\n" +
         "# A cable that is put back: until the others' addresses are asked for again, nobody hears this host.\n" +
         "net/ipv4/neigh/" + interface + "/retrans_time_ms = " + std::to_string(kAddressRetry_ms) + "\n";
}

}  // namespace

std::string target_of(const robot::Robot& robot) { return "farrier-" + robot.name + ".target"; }

std::string unit_of(const robot::Robot& robot, const std::string& process) {
  return "farrier-" + robot.name + "-" + process + ".service";
}

Result<std::vector<RenderedFile>> render_host(const robot::Robot& robot, const std::string& robot_text,
                                              const std::string& host, const Places& places) {
  const auto processes = FARRIER_TRY(processes_of(robot, host, places));
  std::vector<RenderedFile> files;
  for (const DeployedProcess& process : processes) {
    files.push_back({unit_of(robot, process.options.name), unit_text(robot, host, places, process)});
  }
  const auto on_realtime_clock = [](const DeployedProcess& process) {
    return process.options.clock == bus::ClockKind::kRealtime;
  };
  if (std::ranges::any_of(processes, on_realtime_clock)) {
    files.push_back({unit_of(robot, "awake"), awake_text(robot, host)});
  }
  files.push_back({target_of(robot), target_text(robot, host, files)});
  files.push_back({"60-farrier-" + robot.name + ".conf", network_text(robot, host)});
  files.push_back({std::filesystem::path(places.robot_file(robot)).filename().string(), robot_text});
  return files;
}

}  // namespace farrier::deploy
