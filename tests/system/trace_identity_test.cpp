// A lock-step run gives the same trace bit for bit over every transport, however joints are grouped into processes, and
// whatever process a debugger blocks.

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "farrier_command.hpp"

namespace farrier::test {
namespace trace_identity_test {

using namespace std::chrono_literals;

const char* const kDuration = tested_duration("1.5");

std::string trace_of(const std::string& dds, const std::string& nodes) {
  return trace_of_trot({"--dds", dds, "--nodes", nodes, "--duration", kDuration});
}

const std::string& reference_trace() {
  static const std::string trace = trace_of("inproc", "per-leg");
  return trace;
}

TEST(TraceIdentity, IsThatOfRunsInWhichGainsWereUpdated) {
  const ScratchDirectory scratch;
  std::string output;
  run_farrier({"trot", "--world", "bench", "--dds", "mixed", "--duration", kDuration, "--out", scratch.file("out")},
              &output);
  const nlohmann::json figures = read_json(scratch.file("out/figures.json"))["figures"];
  const auto updates =
      std::ranges::find_if(figures, [](const auto& figure) { return figure["name"] == "trot.updates"; });
  ASSERT_NE(updates, figures.end()) << output;
  EXPECT_GE((*updates)["value"].get<double>(), 1.0);
}

struct Way {
  const char* dds;
  const char* nodes;
};

class TraceOverEveryTransport : public testing::TestWithParam<Way> {};

TEST_P(TraceOverEveryTransport, EqualsTheInProcessTraceByteForByte) {
  ASSERT_GT(reference_trace().size(), 1000u);
  EXPECT_TRUE(trace_of(GetParam().dds, GetParam().nodes) == reference_trace());
}

INSTANTIATE_TEST_SUITE_P(Over, TraceOverEveryTransport,
                         testing::Values(Way{"inproc", "per-joint"}, Way{"inproc", "one"}, Way{"cyclone", "per-leg"},
                                         Way{"cyclone", "per-joint"}, Way{"fast", "per-leg"}, Way{"fast", "per-joint"},
                                         Way{"mixed", "per-leg"}, Way{"mixed", "per-joint"}, Way{"mixed", "one"}),
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
  FarrierCommand trot({"trot", "--world", "bench", "--dds", GetParam().dds, "--duration", kDuration, "--out",
                       scratch.file("out"), "--trace", scratch.file("trace.csv")});
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

TEST(TraceOnALoopbackWithoutMulticast, CarriesTheRunOfOneProcessPerJointOverBothVendors) {
  if (std::system("unshare -n true 2>/dev/null") != 0) {
    GTEST_SKIP() << "this user may not make a network namespace";
  }
  const ScratchDirectory scratch;
  const std::string command = std::string("unshare -n sh -c 'ip link set lo up && ") + FARRIER_COMMAND +
                              " trot --world bench --dds mixed --nodes per-joint --duration " + kDuration + " --out " +
                              scratch.file("out") + " --trace " + scratch.file("trace.csv") + "' >/dev/null 2>&1";
  static_cast<void>(std::system(command.c_str()));  // too short to be judged: the trace is what counts
  EXPECT_TRUE(read_file(scratch.file("trace.csv")) == reference_trace());
}

TEST(TwoRunsAtOnce, DoNotHearEachOther) {
  std::string first;
  std::string second;
  std::thread other([&] { first = trace_of("cyclone", "per-leg"); });
  second = trace_of("mixed", "per-leg");
  other.join();
  EXPECT_TRUE(first == reference_trace());
  EXPECT_TRUE(second == reference_trace());
}

}  // namespace trace_identity_test
}  // namespace farrier::test
