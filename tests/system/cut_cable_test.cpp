// The trot on three hosts in real time, in slow motion as in farrier faults. The cable of the front legs' host is
// pulled and put back. The joints must react as in the table of docs/architecture.md.

#include <gtest/gtest.h>

#include <cstdio>
#include <set>

#include "robot_watch.hpp"
#include "tests/support/needs_network_namespaces.hpp"
#include "undisturbed.hpp"

namespace farrier::test {
namespace cut_cable_test {

// All in ticks, of 1 ms in slow motion.
constexpr Tick kUndisturbed = 1500;
constexpr Tick kCuts[] = {300, 2000};
constexpr Tick kUntilArmed = 300;
constexpr Tick kBefore = 10;  // a joint that hears nothing tells the last tick that it knows
constexpr Tick kAfterwards = 600;
constexpr Tick kNulledWithin = 20;      // 5 without valve commands, and what the watch is behind
constexpr Tick kHeardAgainWithin = 50;  // 150 ms of the machine's: DDS goes by its clock
constexpr Tick kTrackingWithin = 24;    // as docs/faults.md
/// A computer with other users is stopped now and then.
constexpr double kMayNotTrack = 0.1;

/// Times of a cut of the cable, in ticks of the clock, which may be some more by then.
struct Cut {
  Tick begin, end, armed;
};

bool is_heard(const trace::TraceRow& row) { return !is_silent(row); }
bool is_not_null(const trace::TraceRow& row) { return !is_null(row); }
bool is_not_tracking(const trace::TraceRow& row) { return !is_tracking(row); }

/// Result of a run, and its deviations from what it must be.
struct CutRun {
  std::vector<Cut> cuts;
  std::size_t trips = 0;  ///< joints that an operator has heard of by an event of theirs, summed over the cuts
  std::string figures;    ///< for people
  std::string problems;   ///< a line each
};

class CutCable : public NeedsNetworkNamespaces<testing::TestWithParam<const char*>> {};

/// Cuts the cable for each of kCuts and arms the robot after each.
void play(const NetworkNamespaces& network, const DeployedProcesses& processes, const robot::Robot& robot,
          cli::PauseWatch& pauses, CutRun& run) {
  const NetworkNamespaces::Visit visit(network, "brain");
  RobotWatch watch(robot, processes.options_of("supervisor"));
  watch.until(kStanding, kPatience);
  pauses.forget();
  ASSERT_GE(watch.until(kUndisturbed, kPatience), kUndisturbed) << processes.output();
  for (const Tick lasts : kCuts) {
    Cut cut{.begin = watch.now(), .end = 0, .armed = 0};
    network.cut("front");
    cut.end = watch.until(cut.begin + lasts, kPatience);
    network.restore("front");
    cut.armed = watch.until(cut.end + kUntilArmed, kPatience);
    watch.arm();
    ASSERT_GE(watch.until(cut.armed + kAfterwards, kPatience), cut.armed + kAfterwards) << processes.output();
    run.cuts.push_back(cut);
  }
  for (const Cut& cut : run.cuts) {
    std::set<std::uint16_t> tripped;
    for (const signals::SystemEvent& event : watch.monitor().events()) {
      const bool of_the_cut = event.tick > cut.begin - kBefore && event.tick < cut.end;
      if (of_the_cut &&
          signals::text_of(event.text).find("tripped, sensors stale, command stale") != std::string::npos) {
        tripped.insert(event.joint);
      }
    }
    run.trips += tripped.size();
  }
}

double share(const JointCourse& legs, bool (*as)(const trace::TraceRow&), Tick begin, Tick end) {
  return static_cast<double>(legs.count(as, begin, end)) / static_cast<double>(legs.joints() * (end - begin));
}

void judge(const JointCourse& front, const JointCourse& hind, CutRun& run) {
  const auto must = [&](bool holds, const std::string& what) { run.problems += holds ? "" : what + "\n"; };
  const Tick undisturbed = run.cuts.front().begin;
  for (const JointCourse* legs : {&front, &hind}) {
    must(legs->count(has_tripped, kStanding, undisturbed) == 0, "a joint trips before the first cut");
    must(share(*legs, is_not_tracking, kStanding, undisturbed) <= kMayNotTrack,
         "joints do not track before the first cut");
  }
  for (const Cut& cut : run.cuts) {
    const auto silent = front.first(is_silent, cut.begin, cut.end);
    const auto heard = front.first(is_heard, cut.end, cut.armed);
    const auto tracking = front.first(is_tracking, cut.armed, cut.armed + kAfterwards);
    if (!silent || !heard || !tracking) {
      must(false, "front legs do not fall silent, are not heard again or do not track again");
      continue;
    }
    const auto ms = [](Tick ticks) { return std::to_string(ticks) + " ms"; };
    run.figures += "cut for " + ms(cut.end - cut.begin) + ": spools at null after " + ms(*silent - cut.begin) +
                   ", heard again after " + ms(*heard - cut.end) + " (" + ms(kSlow * (*heard - cut.end)) +
                   " of the machine's), tracking " + ms(*tracking - cut.armed) + " after the request to arm\n";
    must(*silent - cut.begin <= kNulledWithin, "spools are late at null");
    must(front.count(is_not_null, *silent, cut.armed) == 0, "front spools leave null before they are armed");
    must(*heard - cut.end <= kHeardAgainWithin, "front legs are late heard again");
    must(front.count(has_tripped, *heard, *heard + 1) == front.joints(), "front joints have not tripped");
    must(*tracking - cut.armed <= kTrackingWithin, "front legs track late after the request");
    must(share(front, is_not_tracking, *tracking, cut.armed + kAfterwards) <= kMayNotTrack, "front legs do not go on");
    must(share(hind, is_not_tracking, cut.begin, cut.armed) <= kMayNotTrack, "hind legs do not go on");
  }
  must(hind.count(has_tripped, kStanding, hind.end()) == 0, "a hind joint trips");
  must(run.trips == front.joints() * run.cuts.size(), "an operator has not heard of every trip once the cable is back");
}

TEST_P(CutCable, StopsTheLegsBehindItUntilTheyAreArmedAndNoOthers) {
  expect_undisturbed([](cli::PauseWatch& pauses) -> std::string {
    const DeployedRun deployed = slow_run(GetParam());
    const robot::Robot robot = deployed_robot(deployed);
    const NetworkNamespaces network = network_of(robot);
    DeployedProcesses processes(robot, network, deployed);
    CutRun run;
    play(network, processes, robot, pauses, run);
    const auto trace = trace_after(processes, robot);
    if (!trace) {
      return trace.error().message + "\n";
    }
    judge(JointCourse(robot, trace.value(), {"lf", "rf"}), JointCourse(robot, trace.value(), {"lh", "rh"}), run);
    std::printf("%s:\n%s", GetParam(), run.figures.c_str());
    return run.problems;
  });
}

INSTANTIATE_TEST_SUITE_P(Over, CutCable, testing::ValuesIn(tested_vendors("mixed")),
                         [](const auto& dds) { return std::string(dds.param); });

}  // namespace cut_cable_test
}  // namespace farrier::test
