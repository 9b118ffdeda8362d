// A lock-step run gives the same trace bit for bit over every transport, however joints are grouped into processes, and
// whatever process a debugger blocks. Its samples reach every process that they are for, and no other.

#include <gtest/gtest.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>
#include <thread>

#include "core/processes.hpp"
#include "farrier_command.hpp"

namespace farrier::test {
namespace trace_identity_test {

using namespace std::chrono_literals;

// Every leg has swung and stood, and gains were updated.
const char* const kDuration = tested_duration("0.8");
const long kTicks = std::lround(std::atof(kDuration) * 1e3);
constexpr int kNotPermitted = 77;

/// Moves this process to a network of its own, which has a loopback device without multicast alone; ends it where that
/// is not permitted.
void isolate_network() {
  if (::unshare(CLONE_NEWNET) != 0 && ::unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) {
    std::perror("no network namespace");
    ::_exit(kNotPermitted);
  }
  const int probe = ::socket(AF_INET, SOCK_DGRAM, 0);
  ifreq request{};
  std::strcpy(request.ifr_name, "lo");
  ::ioctl(probe, SIOCGIFFLAGS, &request);
  request.ifr_flags = static_cast<short>((request.ifr_flags | IFF_UP) & ~IFF_MULTICAST);
  if (::ioctl(probe, SIOCSIFFLAGS, &request) != 0) {
    std::perror("loopback cannot be raised");
    ::_exit(kNotPermitted);
  }
  ::close(probe);
}

/// A run's trace, figures and output.
struct TracedRun {
  std::string trace;
  nlohmann::json figures;
  std::string output;
};

/// The run over `dds`, in process for "inproc". Runs of a process for each joint over DDS have a network without
/// multicast, where this user may make one.
TracedRun run_of(const std::string& dds, const std::string& nodes) {
  const ScratchDirectory scratch;
  const std::vector<std::string> arguments{"trot",    "--world",         "bench", "--dds",
                                           dds,       "--nodes",         nodes,   "--duration",
                                           kDuration, "--no-comparison", "--out", scratch.file("out")};
  const bool isolated = dds != "inproc" && nodes == "per-joint";
  TracedRun run;
  const int status = run_farrier(arguments, &run.output, {FARRIER_COMMAND, isolated ? isolate_network : nullptr});
  if (status == kNotPermitted) {
    std::printf("with this computer's network: %s", run.output.c_str());
    run_farrier(arguments, &run.output);
  }
  run.trace = read_file(scratch.file("out/trace.csv"));
  run.figures = read_json(scratch.file("out/figures.json"));
  return run;
}

/// Each run is made once.
const TracedRun& shared_run(const std::string& dds, const std::string& nodes) {
  static std::map<std::string, TracedRun> runs;
  const std::string key = dds + ' ' + nodes;
  if (!runs.contains(key)) {
    runs[key] = run_of(dds, nodes);
  }
  return runs.at(key);
}

const std::string& reference_trace() { return shared_run("inproc", "per-leg").trace; }

TEST(TraceIdentity, IsThatOfRunsInWhichGainsWereUpdated) {
  const TracedRun& run = shared_run("inproc", "per-leg");
  ASSERT_FALSE(run.figures.is_discarded()) << run.output;
  EXPECT_GE(figure(run.figures, "trot.updates"), 1.0);
}

TEST(NoComparison, LeavesOutTheRunOfTheSwingDesign) {
  const TracedRun& run = shared_run("inproc", "per-leg");
  ASSERT_FALSE(run.figures.is_discarded()) << run.output;
  for (const auto& entry : run.figures["figures"]) {
    EXPECT_EQ(entry["name"].get<std::string>().find("swing_design"), std::string::npos) << entry;
  }
}

struct Way {
  const char* dds;
  const char* nodes;
};

class TraceOverEveryTransport : public testing::TestWithParam<Way> {};

TEST_P(TraceOverEveryTransport, EqualsTheInProcessTraceByteForByte) {
  ASSERT_GT(reference_trace().size(), 1000u);
  const TracedRun& run = shared_run(GetParam().dds, GetParam().nodes);
  EXPECT_TRUE(run.trace == reference_trace()) << run.output;
}

// A process for each leg over each transport: TraceUnderADebuggersPause and TwoRunsAtOnce.
INSTANTIATE_TEST_SUITE_P(Over, TraceOverEveryTransport,
                         testing::Values(Way{"inproc", "per-joint"}, Way{"inproc", "one"}, Way{"cyclone", "per-joint"},
                                         Way{"fast", "per-joint"}, Way{"mixed", "per-joint"}, Way{"mixed", "one"}),
                         [](const auto& way) {
                           std::string name = std::string(way.param.dds) + "_" + way.param.nodes;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

struct Pause {
  const char* dds;
  const char* process;
};

class TraceUnderADebuggersPause : public testing::TestWithParam<Pause> {};

TEST_P(TraceUnderADebuggersPause, IsTheSame) {
  const ScratchDirectory scratch;
  FarrierCommand trot({"trot", "--world", "bench", "--dds", GetParam().dds, "--duration", kDuration, "--no-comparison",
                       "--out", scratch.file("out"), "--trace", scratch.file("trace.csv")});
  const pid_t paused = trot.process(GetParam().process);
  ASSERT_NE(paused, 0);
  // A tenth of the run is over when the first line of progress behind the start is out.
  ASSERT_TRUE(trot.says("trot: tick 1") || trot.says("trot: tick 2"));
  ASSERT_EQ(::kill(paused, SIGSTOP), 0);
  std::this_thread::sleep_for(1s);
  ASSERT_EQ(::kill(paused, SIGCONT), 0);
  EXPECT_NE(trot.wait(), -1);
  EXPECT_TRUE(read_file(scratch.file("trace.csv")) == reference_trace());
}

INSTANTIATE_TEST_SUITE_P(Of, TraceUnderADebuggersPause,
                         testing::Values(Pause{"cyclone", "sim_bridge"}, Pause{"cyclone", "supervisor"},
                                         Pause{"fast", "joint_node_lf"}, Pause{"mixed", "estimator_service"}),
                         [](const auto& pause) { return std::string(pause.param.dds) + "_" + pause.param.process; });

TEST(TwoRunsAtOnce, DoNotHearEachOther) {
  TracedRun first;
  std::thread other([&] { first = run_of("cyclone", "per-leg"); });
  const TracedRun second = run_of("mixed", "per-leg");
  other.join();
  EXPECT_TRUE(first.trace == reference_trace()) << first.output;
  EXPECT_TRUE(second.trace == reference_trace()) << second.output;
}

constexpr long kJoints = 12;
constexpr std::size_t kParticipants = kPrograms.size() - 1 + kJoints;  // a joint_node per joint; not the launcher

struct Count {
  long sent = 0;
  long received = 0;
  long lost = 0;
};

/// Samples of each topic by process, and who the processes were.
struct Traffic {
  std::map<std::string, std::map<std::string, Count>> by_topic;
  std::size_t processes = 0;
  std::set<int> pids;

  long sent(const std::string& topic) const { return sum(topic, &Count::sent); }
  long received(const std::string& topic) const { return sum(topic, &Count::received); }
  long lost(const std::string& topic) const { return sum(topic, &Count::lost); }

 private:
  long sum(const std::string& topic, long Count::*what) const {
    long total = 0;
    for (const auto& [process, count] : by_topic.at(topic)) {
      total += count.*what;
    }
    return total;
  }
};

Traffic traffic_over(const std::string& dds) {
  const nlohmann::json& figures = shared_run(dds, "per-joint").figures;
  Traffic traffic;
  if (figures.is_discarded()) {
    return traffic;
  }
  for (const auto& process : figures["run"]["processes"]) {
    ++traffic.processes;
    traffic.pids.insert(process["pid"].get<int>());
    for (const auto& topic : process["topics"]) {
      traffic.by_topic[topic["topic"]][process["name"]] = {topic["sent"], topic["received"], topic["lost"]};
    }
  }
  return traffic;
}

class LockstepTraffic : public testing::TestWithParam<const char*> {};

TEST_P(LockstepTraffic, ReachesEveryoneItIsForAndNobodyElse) {
  const Traffic traffic = traffic_over(GetParam());
  const bool in_process = GetParam() == std::string("inproc");
  const std::size_t participants = kParticipants + (in_process ? 0 : 1);
  ASSERT_EQ(traffic.processes, participants);
  EXPECT_EQ(traffic.pids.size(), in_process ? 1 : participants);

  // One sample a joint and tick. Sensors and valve commands have one reader each; a reader of measurements gets all.
  for (const char* topic : {"joint/sensors", "joint/valve_command", "joint/measurement"}) {
    EXPECT_EQ(traffic.sent(topic), kJoints * kTicks) << topic;
  }
  for (const char* topic : {"joint/sensors", "joint/valve_command"}) {
    EXPECT_EQ(traffic.received(topic), traffic.sent(topic)) << topic;
  }
  for (const auto& [process, count] : traffic.by_topic.at("joint/measurement")) {
    const bool reads = count.received > 0 || process == "estimator_service";
    EXPECT_EQ(count.received, reads ? kJoints * kTicks : 0) << process;
    EXPECT_FALSE(reads && (process.starts_with("joint_node") || process == "sim_bridge")) << process;
  }
  for (const auto& [process, count] : traffic.by_topic.at("joint/sensors")) {
    if (process.starts_with("joint_node")) {
      EXPECT_EQ(count.received, kTicks) << process;
    }
  }
  // Locomotion is one tick ahead, which the last tick of a run may cut off.
  EXPECT_EQ(traffic.sent("joint/command"), kJoints * (kTicks + 1));
  EXPECT_LE(traffic.received("joint/command"), traffic.sent("joint/command"));
  EXPECT_GE(traffic.received("joint/command"), kJoints * kTicks);

  const long others = static_cast<long>(participants) - 1;
  EXPECT_EQ(traffic.sent("clock/tick_done"), others * kTicks);
  EXPECT_EQ(traffic.received("clock/tick_done"), others * kTicks);
  EXPECT_EQ(traffic.by_topic.at("clock/tick_done").at("sim_bridge").received, others * kTicks);

  for (const auto& [topic, processes] : traffic.by_topic) {
    EXPECT_EQ(traffic.lost(topic), 0) << topic;
  }
}

INSTANTIATE_TEST_SUITE_P(Over, LockstepTraffic, testing::Values("inproc", "cyclone", "fast", "mixed"),
                         [](const auto& dds) { return std::string(dds.param); });

}  // namespace trace_identity_test
}  // namespace farrier::test
