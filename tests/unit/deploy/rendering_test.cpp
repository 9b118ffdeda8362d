#include <sys/wait.h>

#include <algorithm>
#include <set>

#include "core/processes.hpp"
#include "files.hpp"

namespace farrier::deploy {
namespace rendering_test {

std::string text_of(const std::vector<RenderedFile>& files, const std::string& name) {
  const auto file = std::find_if(files.begin(), files.end(), [&](const RenderedFile& f) { return f.name == name; });
  return file == files.end() ? "" : file->text;
}

bool has_line(const std::string& text, const std::string& line) {
  return ("\n" + text).find("\n" + line + "\n") != std::string::npos;
}

/// Returns the argument after `flag` in a unit's command line.
std::string argument(const std::string& unit, const std::string& flag) {
  const auto at = unit.find(" " + flag + " ");
  if (at == std::string::npos) {
    return "";
  }
  const auto begin = at + flag.size() + 2;
  return unit.substr(begin, unit.find_first_of(" \n", begin) - begin);
}

TEST(Rendering, GivesAHostItsProcessesAndNobodyElses) {
  std::vector<std::string> names;
  for (const RenderedFile& file : rendered("front")) {
    names.push_back(file.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"farrier-hyq-joint_node_lf.service", "farrier-hyq-joint_node_rf.service",
                                             "farrier-hyq-awake.service", "farrier-hyq.target", "60-farrier-hyq.conf",
                                             "hyq.yaml"}));
}

TEST(Rendering, NumbersProcessesAlikeOnEveryHostAndEachOnce) {
  constexpr std::size_t kJointNodes = 4;
  constexpr std::size_t kProcesses = kPrograms.size() - 1 + kJointNodes;
  std::set<std::string> numbers;
  for (const char* host : {"front", "hind", "brain"}) {
    for (const RenderedFile& file : rendered(host)) {
      if (file.name.ends_with(".service") && file.name != "farrier-hyq-awake.service") {
        EXPECT_EQ(argument(file.text, "--participants"), std::to_string(kProcesses)) << file.name;
        EXPECT_EQ(argument(file.text, "--peers"), "192.168.20.11,192.168.20.12,192.168.20.10") << file.name;
        EXPECT_EQ(argument(file.text, "--domain"), "20") << file.name;
        EXPECT_TRUE(numbers.insert(argument(file.text, "--number")).second) << file.name;
      }
    }
  }
  EXPECT_EQ(numbers.size(), kProcesses);
  for (std::size_t number = 0; number < kProcesses; ++number) {
    EXPECT_TRUE(numbers.contains(std::to_string(number))) << number;
  }
}

TEST(Rendering, PinsTheHostsAddressVendorAndJoints) {
  const std::string lf = text_of(rendered("front"), "farrier-hyq-joint_node_lf.service");
  EXPECT_EQ(argument(lf, "--address"), "192.168.20.11");
  EXPECT_EQ(argument(lf, "--dds"), "cyclone");
  EXPECT_EQ(argument(lf, "--joints"), "lf_haa,lf_hfe,lf_kfe");
  EXPECT_EQ(argument(lf, "--clock"), "realtime");
  EXPECT_EQ(argument(lf, "--robot"), "/etc/farrier/hyq/hyq.yaml");
  const std::string supervisor = text_of(rendered("brain"), "farrier-hyq-supervisor.service");
  EXPECT_EQ(argument(supervisor, "--dds"), "fast");
  EXPECT_EQ(argument(supervisor, "--number"), std::to_string(participant::kSupervisor));
}

TEST(Rendering, SetsTheKernelsNetworkForDdsAndForCablesThatComeBack) {
  const std::string settings = text_of(rendered("front"), "60-farrier-hyq.conf");
  for (const char* line :
       {"net.core.rmem_max = 4194304", "net.core.wmem_max = 4194304", "net/ipv4/neigh/eth0/retrans_time_ms = 20"}) {
    EXPECT_TRUE(has_line(settings, line)) << settings;
  }
}

TEST(Rendering, ProbesValvesOnlyWhereGainsAreAdapted) {
  robot::Robot robot = hyq();
  for (const auto& [design, probes] : {std::pair(robot::Design::kPhases, false), {robot::Design::kAdaptive, true}}) {
    robot.file.deployment->design = design;
    const auto files = render_host(robot, "", "front", standard_places(robot));
    const std::string lf = text_of(files.value(), "farrier-hyq-joint_node_lf.service");
    EXPECT_EQ(lf.find("--no-dither") == std::string::npos, probes);
  }
}

TEST(Rendering, LetsTheUnitAllowPrioritiesAndTheProcessSetThem) {
  const std::string lf = text_of(rendered("front"), "farrier-hyq-joint_node_lf.service");
  for (const char* line : {"Type=notify", "WatchdogSec=1", "Restart=on-failure", "CPUAffinity=1", "LimitRTPRIO=80",
                           "LimitMEMLOCK=infinity", "MemoryMax=512M", "DynamicUser=yes"}) {
    EXPECT_TRUE(has_line(lf, line)) << line;
  }
  EXPECT_EQ(lf.find("CPUScheduling"), std::string::npos) << "every thread would get that priority";
  EXPECT_EQ(lf.find("RestrictRealtime"), std::string::npos) << "no thread would get one";
}

TEST(Rendering, KeepsProcessorsOutOfIdleStatesOnTheRealTimeClockOnly) {
  const std::string unit = "farrier-hyq-awake.service";
  EXPECT_TRUE(has_line(text_of(rendered("front"), unit), "DeviceAllow=/dev/cpu_dma_latency rw"));
  EXPECT_NE(text_of(rendered("front"), "farrier-hyq.target").find(unit), std::string::npos);

  robot::Robot robot = hyq();
  robot.file.deployment->clock = ClockKind::kLockstep;
  const auto files = render_host(robot, "", "front", standard_places(robot));
  EXPECT_EQ(text_of(files.value(), unit), "");
  EXPECT_EQ(text_of(files.value(), "farrier-hyq.target").find(unit), std::string::npos);
}

TEST(Rendering, ShiftsThePrioritiesOfAHostTogether) {
  robot::Robot robot = hyq();
  for (auto& [name, host] : robot.file.deployment->hosts) {
    host.priority_shift = name == "front" ? -10 : 0;
  }
  const auto files = render_host(robot, "", "front", standard_places(robot));
  const std::string lf = text_of(files.value(), "farrier-hyq-joint_node_lf.service");
  EXPECT_TRUE(has_line(lf, "LimitRTPRIO=70")) << lf;
  EXPECT_EQ(argument(lf, "--priority-shift"), "-10");
}

TEST(Rendering, KeepsWhatSystemdWouldReadOtherwise) {
  Places places = standard_places(hyq());
  places.folder = "/srv/my robots/100% $HOME";
  const std::string lf = text_of(rendered("front", places), "farrier-hyq-joint_node_lf.service");
  EXPECT_NE(lf.find(" --robot \"/srv/my robots/100%% $$HOME/hyq.yaml\" "), std::string::npos) << lf;
}

TEST(Rendering, RefusesAHostThatIsNotThereAndNamesThoseThatAre) {
  const auto files = render_host(hyq(), "", "tail", standard_places(hyq()));
  ASSERT_FALSE(files.ok());
  EXPECT_EQ(files.error().message, kHyqPath + ": deployment.hosts: no host 'tail': give one of front, hind, brain");
}

TEST(Rendering, RefusesARobotWithoutDeployment) {
  const auto rig = robot::load_robot(FARRIER_ROBOTS "fc1d.yaml");
  const auto files = render_host(rig.value(), "", "front", standard_places(rig.value()));
  ASSERT_FALSE(files.ok());
  EXPECT_NE(files.error().message.find("has no deployment"), std::string::npos);
}

TEST(Rendering, PassesSystemdsOwnCheckWithoutAWarning) {
  if (std::system("systemd-analyze --version > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "systemd-analyze is not installed: apt install systemd";
  }
  const ScratchDirectory scratch;
  Places places{.prefix = scratch.file("usr"), .folder = scratch.file("units")};
  std::filesystem::create_directories(scratch.file("usr/libexec/farrier"));
  std::filesystem::create_directories(places.folder);
  for (const ProgramInfo& one : kPrograms) {
    std::filesystem::create_symlink("/bin/true", scratch.file("usr/libexec/farrier/" + std::string(one.name)));
  }
  for (const char* host : {"front", "hind", "brain"}) {
    std::string units;
    for (const RenderedFile& file : rendered(host, places)) {
      std::ofstream(places.folder + "/" + file.name) << file.text;
      units += file.name.ends_with(".service") || file.name.ends_with(".target") ? " " + file.name : "";
    }
    const std::string said = scratch.file("said");
    const std::string verify = "cd " + places.folder + " && systemd-analyze verify" + units + " > " + said + " 2>&1";
    const int status = std::system(verify.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 0) << host << ": " << read(said);
    EXPECT_EQ(read(said), "") << host;
  }
}

}  // namespace rendering_test
}  // namespace farrier::deploy
